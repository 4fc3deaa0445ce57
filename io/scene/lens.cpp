// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/lens.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

/// Coefficients by their names; those that a file leaves out are 0.
struct Radial {
  explicit Radial(const std::vector<double>& c) {
    const auto at = [&](std::size_t i) { return i < c.size() ? c[i] : 0; };
    numerator = {at(0), at(1), at(4)};
    denominator = {at(5), at(6), at(7)};
    p1 = at(2), p2 = at(3);
    prism = {at(8), at(9), at(10), at(11)};
  }

  static double polynomial(const std::array<double, 3>& k, double r2) {
    return 1 + r2 * (k[0] + r2 * (k[1] + r2 * k[2]));
  }

  double scale(double r2) const { return polynomial(numerator, r2) / polynomial(denominator, r2); }

  std::array<double, 3> numerator{}, denominator{};
  double p1 = 0, p2 = 0;
  std::array<double, 4> prism{};
};

double fisheye_angle(const std::vector<double>& c, double theta) {
  const auto at = [&](std::size_t i) { return i < c.size() ? c[i] : 0; };
  const double t2 = theta * theta;
  return theta * (1 + t2 * (at(0) + t2 * (at(1) + t2 * (at(2) + t2 * at(3)))));
}

}  // namespace

bool Lens::distorts() const {
  return model == Model::equidistant ||
         std::any_of(coefficients.begin(), coefficients.end(), [](double value) { return value != 0; });
}

cv::Point2d Lens::distorted(cv::Point2d point) const {
  const double x = point.x, y = point.y, r2 = x * x + y * y, r = std::sqrt(r2);
  if (model == Model::equidistant) return r > 0 ? point * (fisheye_angle(coefficients, std::atan(r)) / r) : point;
  const Radial c(coefficients);
  const double scale = c.scale(r2);
  return {x * scale + 2 * c.p1 * x * y + c.p2 * (r2 + 2 * x * x) + r2 * (c.prism[0] + r2 * c.prism[1]),
          y * scale + c.p1 * (r2 + 2 * y * y) + 2 * c.p2 * x * y + r2 * (c.prism[2] + r2 * c.prism[3])};
}

double Lens::largest_radius(double most) const {
  constexpr int steps = 1024;
  const Radial radial(coefficients);
  double last = 0;
  for (int i = 1; i <= steps; ++i) {
    const double r = most * i / steps;
    const double seen =
        model == Model::equidistant ? fisheye_angle(coefficients, std::atan(r)) : r * radial.scale(r * r);
    if (!(seen > last)) return most * (i - 1) / steps;
    last = seen;
  }
  return most;
}

double largest_radius_of(const Camera& camera) {
  const double x = std::max(camera.cx, camera.width - 1 - camera.cx) / camera.fx,
               y = std::max(camera.cy, camera.height - 1 - camera.cy) / camera.fy;
  return std::hypot(x, y);
}

double largest_shift(const Lens& lens, const Camera& camera) {
  constexpr int steps = 32;
  double largest = 0;
  if (!lens.distorts()) return largest;
  const double corner = largest_radius_of(camera);
  if (lens.largest_radius(corner) < corner) return std::numeric_limits<double>::infinity();
  for (int i = 0; i <= steps; ++i)
    for (int j = 0; j <= steps; ++j) {
      const cv::Point2d point((double(i) / steps * (camera.width - 1) - camera.cx) / camera.fx,
                              (double(j) / steps * (camera.height - 1) - camera.cy) / camera.fy);
      const cv::Point2d shift = lens.distorted(point) - point;
      const double pixels = std::hypot(shift.x * camera.fx, shift.y * camera.fy);
      largest = std::max(largest, pixels);
    }
  return largest;
}

}  // namespace gestalt
