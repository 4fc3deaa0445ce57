// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "oriented_box.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "gestalt/core/base/quantile.h"

namespace gestalt {

namespace {

constexpr double outliers = 0.005;  // share at either end
constexpr double clearly = 0.9;     // of an area, below which the outline is believed rather than a side

struct Range {
  double low, high;
  double size() const { return high - low; }
};

Range range_along(const Points& points, const Eigen::Vector3d& axis) {
  std::vector<double> places(points.size());
  std::transform(points.begin(), points.end(), places.begin(), [&](const Eigen::Vector3d& p) { return axis.dot(p); });
  return {quantile(places, outliers), quantile(places, 1 - outliers)};
}

/// A direction across up with the area of the rectangle along it.
struct Direction {
  Eigen::Vector3d axis;
  double area;
};

Direction direction(const Points& points, const Eigen::Vector3d& axis, const Eigen::Vector3d& up) {
  return {axis, range_along(points, axis).size() * range_along(points, up.cross(axis)).size()};
}

/// A side of the smallest rectangle around the points, as seen along up.
Eigen::Vector3d side_of_outline(const Points& points, const Eigen::Vector3d& up) {
  const auto [x, y] = across(up);
  const Eigen::Vector3d& origin = points.front();
  std::vector<cv::Point2f> flat, hull;
  for (const Eigen::Vector3d& p : points) flat.emplace_back(float(x.dot(p - origin)), float(y.dot(p - origin)));
  cv::convexHull(flat, hull);
  if (hull.size() < 3) return x;
  const double angle = cv::minAreaRect(hull).angle * CV_PI / 180;
  return std::cos(angle) * x + std::sin(angle) * y;
}

}  // namespace

std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& up) {
  const Eigen::Vector3d x = up.unitOrthogonal();
  return {x, up.cross(x)};
}

OrientedBox box_around(const Points& points, const Eigen::Vector3d& up, const Points& normals) {
  constexpr double least_slope = 0.5;  // a surface that faces up says nothing about the direction
  constexpr std::size_t most_sides = 3;
  OrientedBox box;
  if (points.empty()) return box;
  Direction best = direction(points, side_of_outline(points, up), up);
  for (std::size_t i = 0; i < std::min(normals.size(), most_sides); ++i) {
    const Eigen::Vector3d flat = normals[i] - up * up.dot(normals[i]);
    if (flat.norm() < least_slope) continue;
    const Direction side = direction(points, flat.normalized(), up);
    if (side.area * clearly <= best.area) {
      best = side;
      break;
    }
  }
  Eigen::Vector3d first = best.axis, second = up.cross(first);
  if (range_along(points, first).size() < range_along(points, second).size()) {
    first = second;
    second = up.cross(first);
  }
  box.axes << first, second, up;
  for (int i = 0; i < 3; ++i) {
    const Range range = range_along(points, box.axes.col(i));
    box.size[i] = range.size();
    box.centre += (range.low + range.high) / 2 * box.axes.col(i);
  }
  return box;
}

}  // namespace gestalt
