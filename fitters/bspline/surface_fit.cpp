// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "surface_fit.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <array>

#include "closest_point.h"

namespace gestalt {

namespace {

/// Mean of the degree inner knots of each control point: its place when the surface is evenly parametrised (Greville).
std::vector<double> greville_abscissae(int degree, const std::vector<double>& knots) {
  std::vector<double> places;
  for (std::size_t i = 0; i + std::size_t(degree) + 1 < knots.size(); ++i) {
    double sum = 0;
    for (int k = 1; k <= degree; ++k) sum += knots[i + std::size_t(k)];
    places.push_back(sum / degree);
  }
  return places;
}

/// Integrals of products of two basis functions, of their first, and of their second derivatives.
struct Products {
  Eigen::MatrixXd value, first_derivative, second_derivative;
};

Products integrate_products(int degree, const std::vector<double>& knots) {
  // Gauss and Legendre's rule of 6 places is exact for products of two polynomials of degree 5.
  constexpr std::array<double, 6> places{-0.9324695142031521, -0.6612093864662645, -0.2386191860831969,
                                         0.2386191860831969,  0.6612093864662645,  0.9324695142031521};
  constexpr std::array<double, 6> weights{0.1713244923791704, 0.3607615730481386, 0.4679139345726910,
                                          0.4679139345726910, 0.3607615730481386, 0.1713244923791704};
  const Eigen::Index n = Eigen::Index(knots.size()) - degree - 1;
  const Eigen::MatrixXd zero = Eigen::MatrixXd::Zero(n, n);
  Products sums{zero, zero, zero};
  for (std::size_t k = std::size_t(degree); k < std::size_t(n); ++k) {
    const double half = (knots[k + 1] - knots[k]) / 2, middle = (knots[k + 1] + knots[k]) / 2;
    if (half <= 0) continue;
    for (std::size_t g = 0; g < places.size(); ++g) {
      const BsplineBasis basis = bspline_basis(degree, knots, middle + half * places[g]);
      const auto add = [&](Eigen::MatrixXd& sum, const BsplineBasis::Values& values) {
        const Eigen::Map<const Eigen::VectorXd> v(values.data(), degree + 1);
        sum.block(basis.first, basis.first, degree + 1, degree + 1) += half * weights[g] * v * v.transpose();
      };
      add(sums.value, basis.value);
      add(sums.first_derivative, basis.first_derivative);
      add(sums.second_derivative, basis.second_derivative);
    }
  }
  return sums;
}

/// The normal equations of Eq. 6 for given closest points.
struct NormalEquations {
  Eigen::MatrixXd matrix;
  Eigen::Matrix<double, Eigen::Dynamic, 3> right;

  /// Adds a point that is to lie at those parameters.
  void add(const BsplineSurface& s, const WeightedPoint& p, const Eigen::Vector2d& at) {
    const BsplineBasis across = bspline_basis(s.degree, s.knots_xi, at.x()),
                       down = bspline_basis(s.degree, s.knots_eta, at.y());
    constexpr int most = (BsplineBasis::largest_degree + 1) * (BsplineBasis::largest_degree + 1);
    std::array<double, most> weights;
    std::array<Eigen::Index, most> places;
    std::size_t count = 0;
    for (int j = 0; j <= s.degree; ++j)
      for (int i = 0; i <= s.degree; ++i, ++count) {
        weights[count] = down.value[std::size_t(j)] * across.value[std::size_t(i)];
        places[count] = (down.first + j) * s.columns() + across.first + i;
      }
    for (std::size_t a = 0; a < count; ++a) {
      const double weight = p.weight * weights[a];
      right.row(places[a]) += weight * p.point.transpose();
      for (std::size_t b = 0; b <= a; ++b) matrix(places[a], places[b]) += weight * weights[b];  // places ascend
    }
  }
};

/// Middle of the knot span with the largest sum of errors.
double worst_span_middle(const std::vector<double>& knots, std::span<const double> places,
                         std::span<const double> errors) {
  std::vector<double> sums(knots.size(), 0);
  for (std::size_t i = 0; i < places.size(); ++i) {
    const auto after = std::upper_bound(knots.begin(), std::lower_bound(knots.begin(), knots.end(), 1.0), places[i]);
    sums[std::size_t(after - knots.begin()) - 1] += errors[i];
  }
  const std::size_t worst = std::size_t(std::max_element(sums.begin(), sums.end()) - sums.begin());
  return (knots[worst] + knots[worst + 1]) / 2;
}

}  // namespace

BsplineSurface flat_surface(const PrincipalFrame& frame, int degree, int columns, int rows) {
  BsplineSurface surface{degree, clamped_knots(degree, columns), clamped_knots(degree, rows), {}};
  const std::vector<double> xi = greville_abscissae(degree, surface.knots_xi),
                            eta = greville_abscissae(degree, surface.knots_eta);
  for (const double y : eta)
    for (const double x : xi) surface.points.push_back(frame.corner + x * frame.across + y * frame.down);
  return surface;
}

Eigen::MatrixXd smoothness_matrix(const BsplineSurface& surface) {
  const Products x = integrate_products(surface.degree, surface.knots_xi),
                 y = integrate_products(surface.degree, surface.knots_eta);
  const Eigen::Index columns = surface.columns(), rows = surface.rows();
  Eigen::MatrixXd matrix(columns * rows, columns * rows);
  for (Eigen::Index j = 0; j < rows; ++j)
    for (Eigen::Index l = 0; l < rows; ++l)
      matrix.block(j * columns, l * columns, columns, columns) = y.value(j, l) * x.second_derivative +
                                                                 2 * y.first_derivative(j, l) * x.first_derivative +
                                                                 y.second_derivative(j, l) * x.value;
  return matrix / 720;
}

bool fit_surface(BsplineSurface& surface, std::span<const WeightedPoint> points,
                 std::vector<Eigen::Vector2d>& parameters, const Eigen::MatrixXd& smoothness, double weight,
                 int iterations) {
  const Eigen::Vector3d origin = surface.points.front();  // near the points, for the sake of rounding
  for (int iteration = 0; iteration < iterations; ++iteration) {
    NormalEquations equations{weight * smoothness, decltype(NormalEquations::right)::Zero(smoothness.rows(), 3)};
    for (std::size_t k = 0; k < points.size(); ++k) {
      if (iteration > 0) parameters[k] = closest_point(surface, points[k].point, parameters[k]).parameters;
      equations.add(surface, {points[k].point - origin, points[k].weight}, parameters[k]);
    }
    const Eigen::LDLT<Eigen::MatrixXd, Eigen::Lower> solver(equations.matrix);
    const Eigen::Matrix<double, Eigen::Dynamic, 3> solution = solver.solve(equations.right);
    if (solver.info() != Eigen::Success || !solution.allFinite()) return false;
    for (std::size_t i = 0; i < surface.points.size(); ++i)
      surface.points[i] = origin + solution.row(Eigen::Index(i)).transpose();
  }
  return true;
}

void insert_knots(BsplineSurface& surface, std::span<const WeightedPoint> points,
                  std::vector<Eigen::Vector2d>& parameters) {
  std::vector<double> errors, xi, eta;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const ClosestPoint closest = closest_point(surface, points[k].point, parameters[k]);
    parameters[k] = closest.parameters;
    errors.push_back(points[k].weight * closest.squared_distance);
    xi.push_back(closest.parameters.x());
    eta.push_back(closest.parameters.y());
  }
  surface.insert_knot_xi(worst_span_middle(surface.knots_xi, xi, errors));
  surface.insert_knot_eta(worst_span_middle(surface.knots_eta, eta, errors));
}

}  // namespace gestalt
