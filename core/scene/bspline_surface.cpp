// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/bspline_surface.h"

#include <algorithm>

namespace gestalt {

namespace {

using Values = BsplineBasis::Values;

/// Index k of the span [knots[k], knots[k + 1]) that holds x; of the last one for the domain's end.
int span_of(int degree, const std::vector<double>& knots, double x) {
  const auto begin = knots.begin() + degree, end = knots.end() - degree - 1;
  const auto after = std::upper_bound(begin, end, x);
  const auto span = after == end ? std::lower_bound(begin, end, *end) - 1 : after - 1;
  return int(span - knots.begin());
}

/// 1 / (t_{i + p} - t_i) of the p functions of degree p - 1 over a span, the first being i = span - p + 1.
Values inverse_supports(int p, int span, const std::vector<double>& t) {
  Values inverse{};
  const double* first = &t[std::size_t(span - p) + 1];
  for (int j = 0; j < p; ++j) inverse[std::size_t(j)] = 1 / (first[j + p] - first[j]);
  return inverse;
}

/// The p + 1 functions of degree p over a span from the p of the degree below.
Values raise(const Values& lower, int p, int span, const std::vector<double>& t, const Values& inverse, double x) {
  Values upper{};
  const double* first = &t[std::size_t(span - p) + 1];
  for (int j = 0; j < p; ++j) {
    const std::size_t s = std::size_t(j);
    const double share = (x - first[j]) * inverse[s];
    upper[s + 1] += share * lower[s];
    upper[s] += (1 - share) * lower[s];
  }
  return upper;
}

/// Derivatives of the p + 1 functions of degree p from the values (or derivatives) of the degree below.
Values differentiate(const Values& lower, int p, const Values& inverse) {
  Values upper{};
  for (int j = 0; j < p; ++j) {
    const std::size_t s = std::size_t(j);
    const double slope = p * inverse[s] * lower[s];
    upper[s + 1] += slope;
    upper[s] -= slope;
  }
  return upper;
}

/// The weights with which control points before a knot's insertion make up those after it: new point i is
/// share * old point i + (1 - share) * old point i - 1.
double insertion_share(int degree, const std::vector<double>& t, int span, double x, int i) {
  if (i <= span - degree) return 1;
  if (i > span) return 0;
  const std::size_t s = std::size_t(i);
  return (x - t[s]) / (t[s + std::size_t(degree)] - t[s]);
}

}  // namespace

BsplineBasis bspline_basis(int degree, const std::vector<double>& knots, double x) {
  x = std::clamp(x, knots[std::size_t(degree)], *(knots.end() - degree - 1));
  const int span = span_of(degree, knots, x);
  BsplineBasis basis;
  basis.first = span - degree;
  basis.value[0] = 1;
  for (int p = 1; p <= degree; ++p) {
    const Values inverse = inverse_supports(p, span, knots);
    basis.second_derivative = differentiate(basis.first_derivative, p, inverse);
    basis.first_derivative = differentiate(basis.value, p, inverse);
    basis.value = raise(basis.value, p, span, knots, inverse, x);
  }
  return basis;
}

std::vector<double> clamped_knots(int degree, int control_points) {
  std::vector<double> knots(std::size_t(degree), 0.0);
  const int spans = control_points - degree;
  for (int i = 0; i <= spans; ++i) knots.push_back(double(i) / spans);
  knots.insert(knots.end(), std::size_t(degree), 1.0);
  return knots;
}

Eigen::Vector3d BsplineSurface::point(double xi, double eta) const {
  const BsplineBasis across = bspline_basis(degree, knots_xi, xi), down = bspline_basis(degree, knots_eta, eta);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (int j = 0; j <= degree; ++j) {
    const Eigen::Vector3d* row = &control_point(across.first, down.first + j);
    Eigen::Vector3d line = Eigen::Vector3d::Zero();
    for (int i = 0; i <= degree; ++i) line += across.value[std::size_t(i)] * row[i];
    sum += down.value[std::size_t(j)] * line;
  }
  return sum;
}

BsplineSurface::Derivatives BsplineSurface::derivatives(double xi, double eta) const {
  const BsplineBasis across = bspline_basis(degree, knots_xi, xi), down = bspline_basis(degree, knots_eta, eta);
  Eigen::Vector3d point = Eigen::Vector3d::Zero(), d_xi = point, d_eta = point, xi_xi = point, xi_eta = point,
                  eta_eta = point;
  for (int j = 0; j <= degree; ++j) {
    const Eigen::Vector3d* row = &control_point(across.first, down.first + j);
    Eigen::Vector3d line = Eigen::Vector3d::Zero(), slope = line, bend = line;
    for (int i = 0; i <= degree; ++i) {
      const std::size_t s = std::size_t(i);
      line += across.value[s] * row[i];
      slope += across.first_derivative[s] * row[i];
      bend += across.second_derivative[s] * row[i];
    }
    const std::size_t s = std::size_t(j);
    point += down.value[s] * line;
    d_xi += down.value[s] * slope;
    xi_xi += down.value[s] * bend;
    d_eta += down.first_derivative[s] * line;
    xi_eta += down.first_derivative[s] * slope;
    eta_eta += down.second_derivative[s] * line;
  }
  return {point, d_xi, d_eta, xi_xi, xi_eta, eta_eta};
}

void BsplineSurface::insert_knot_xi(double xi) {
  const int span = span_of(degree, knots_xi, xi), before = columns(), after = before + 1;
  std::vector<Eigen::Vector3d> refined;
  for (int j = 0; j < rows(); ++j) {
    const Eigen::Vector3d* row = &control_point(0, j);
    for (int i = 0; i < after; ++i) {
      const double share = insertion_share(degree, knots_xi, span, xi, i);
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      if (share > 0) sum += share * row[i];
      if (share < 1) sum += (1 - share) * row[i - 1];
      refined.push_back(sum);
    }
  }
  points = std::move(refined);
  knots_xi.insert(knots_xi.begin() + span + 1, xi);
}

void BsplineSurface::insert_knot_eta(double eta) {
  const int span = span_of(degree, knots_eta, eta), before = rows(), width = columns();
  std::vector<Eigen::Vector3d> refined;
  for (int j = 0; j <= before; ++j) {
    const double share = insertion_share(degree, knots_eta, span, eta, j);
    for (int i = 0; i < width; ++i) {
      Eigen::Vector3d sum = Eigen::Vector3d::Zero();
      if (share > 0) sum += share * control_point(i, j);
      if (share < 1) sum += (1 - share) * control_point(i, j - 1);
      refined.push_back(sum);
    }
  }
  points = std::move(refined);
  knots_eta.insert(knots_eta.begin() + span + 1, eta);
}

}  // namespace gestalt
