// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shape_kind.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gestalt/core/scene/moments.h"

namespace gestalt {

namespace {

constexpr double none = std::numeric_limits<double>::infinity();  // error of a shape that does not fit
constexpr std::size_t fewest_points = 50;
constexpr double least_radius = 0.008, largest_radius = 0.3;  // m
constexpr double flat_error = 0.9397;                         // cosine of 20 degrees: normals of noisy surfaces

double square(double x) { return x * x; }

/// Root of the mean squared distance to the plane through all points.
double plane_error(const std::vector<Facet>& facets) {
  Moments moments;
  const Eigen::Vector3d& origin = facets.front().points.front();
  for (const Facet& facet : facets)
    for (const Eigen::Vector3d& p : facet.points) moments.add(p - origin);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance(), Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
}

/// Every surface is a face of the box, or parallel to one: its normal is along an axis.
double box_error(const std::vector<Facet>& facets, const OrientedBox& box) {
  double sum = 0, count = 0;
  for (const Facet& facet : facets) {
    if ((box.axes.transpose() * facet.normal).cwiseAbs().maxCoeff() < flat_error) return none;
    sum += double(facet.points.size()) * square(facet.rms);
    count += double(facet.points.size());
  }
  return std::sqrt(sum / count);
}

/// A circle in a plane, or a sphere: |p|^2 = 2 c p + k by least squares.
template <int dimension>
struct Round {
  using Point = Eigen::Matrix<double, dimension, 1>;
  Point centre = Point::Zero();
  double radius = 0;
  double error = none;  ///< root mean square of distances from it
};

template <int dimension>
Round<dimension> fit_round(const std::vector<typename Round<dimension>::Point>& points) {
  constexpr int unknowns = dimension + 1;
  using Row = Eigen::Matrix<double, unknowns, 1>;
  Round<dimension> found;
  if (points.size() < fewest_points) return found;
  const auto origin = points.front();
  Eigen::Matrix<double, unknowns, unknowns> normal = Eigen::Matrix<double, unknowns, unknowns>::Zero();
  Row right = Row::Zero();
  for (const auto& point : points) {
    const auto p = (point - origin).eval();
    Row row;
    row << 2 * p, 1;
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Row solved = normal.ldlt().solve(right);
  const auto centre = solved.template head<dimension>().eval();
  const double squared = solved[dimension] + centre.squaredNorm();
  if (!solved.allFinite() || !(squared > square(least_radius)) || squared > square(largest_radius)) return found;
  found.centre = origin + centre;
  found.radius = std::sqrt(squared);
  double sum = 0;
  for (const auto& point : points) sum += square((point - found.centre).norm() - found.radius);
  found.error = std::sqrt(sum / double(points.size()));
  return found;
}

/// Whether the part that is seen bends by more than noise can: a piece of a plane is also one of a large circle.
bool bends(double radius, double angle, double tolerance) {
  constexpr double least_angle = 0.9;
  return angle > least_angle && radius * (1 - std::cos(std::min(angle, std::numbers::pi) / 2)) > 3 * tolerance;
}

double sphere_error(const std::vector<Facet>& facets, double tolerance) {
  std::vector<Eigen::Vector3d> points;
  for (const Facet& facet : facets) points.insert(points.end(), facet.points.begin(), facet.points.end());
  const Round<3> sphere = fit_round<3>(points);
  if (sphere.error == none) return none;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& p : points) mean += (p - sphere.centre).normalized();
  mean.normalize();
  double least_cosine = 1;
  for (const Eigen::Vector3d& p : points)
    least_cosine = std::min(least_cosine, mean.dot((p - sphere.centre).normalized()));
  return bends(sphere.radius, 2 * std::acos(std::clamp(least_cosine, -1.0, 1.0)), tolerance) ? sphere.error : none;
}

/// A circle along an axis, and flat ends across it.
double cylinder_error(const std::vector<Facet>& facets, const Eigen::Vector3d& axis, double tolerance) {
  const auto [x, y] = across(axis);
  std::vector<Eigen::Vector2d> side;
  double sum = 0, count = 0;
  for (const Facet& facet : facets) {
    if (std::abs(facet.normal.dot(axis)) > flat_error) {
      sum += double(facet.points.size()) * square(facet.rms);
    } else {
      for (const Eigen::Vector3d& p : facet.points) side.emplace_back(x.dot(p), y.dot(p));
    }
    count += double(facet.points.size());
  }
  const Round<2> circle = fit_round<2>(side);
  if (circle.error == none || double(side.size()) < 0.2 * count) return none;
  // The largest gap between directions is what is not seen.
  std::vector<double> angles;
  angles.reserve(side.size());
  for (const Eigen::Vector2d& p : side)
    angles.push_back(std::atan2(p.y() - circle.centre.y(), p.x() - circle.centre.x()));
  std::sort(angles.begin(), angles.end());
  double gap = angles.front() + 2 * std::numbers::pi - angles.back();
  for (std::size_t i = 1; i < angles.size(); ++i) gap = std::max(gap, angles[i] - angles[i - 1]);
  if (!bends(circle.radius, 2 * std::numbers::pi - gap, tolerance)) return none;
  return std::sqrt((sum + double(side.size()) * square(circle.error)) / count);
}

}  // namespace

std::string_view name_of(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::plane:
      return "plane";
    case ShapeKind::box:
      return "box";
    case ShapeKind::cylinder:
      return "cylinder";
    case ShapeKind::sphere:
      return "sphere";
    case ShapeKind::other:
      break;
  }
  return "other";
}

ShapeKind find_kind(const std::vector<Facet>& facets, const OrientedBox& box, const std::optional<Support>& support,
                    double tolerance) {
  constexpr double thin = 5;  // tolerances over the support
  std::size_t points = 0;
  for (const Facet& facet : facets) points += facet.points.size();
  if (points < fewest_points) return ShapeKind::other;
  const bool low = !support || support->top < thin * tolerance;
  if (low && plane_error(facets) < tolerance) return ShapeKind::plane;

  double cylinder = none;
  for (int i = 0; i < 3; ++i) cylinder = std::min(cylinder, cylinder_error(facets, box.axes.col(i), tolerance));
  const std::pair<double, ShapeKind> shapes[] = {{box_error(facets, box), ShapeKind::box},
                                                 {cylinder, ShapeKind::cylinder},
                                                 {sphere_error(facets, tolerance), ShapeKind::sphere}};
  const auto best = std::min_element(std::begin(shapes), std::end(shapes),
                                     [](const auto& a, const auto& b) { return a.first < b.first; });
  return best->first < tolerance ? best->second : ShapeKind::other;
}

}  // namespace gestalt
