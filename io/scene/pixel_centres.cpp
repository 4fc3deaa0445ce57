// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pixel_centres.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

/// Where a point is seen, in pixels.
cv::Point2d seen_at(const cv::Vec3f& p, const Camera& camera) {
  return {camera.fx * p[0] / p[2] + camera.cx, camera.fy * p[1] / p[2] + camera.cy};
}

double median_offset(const std::vector<int>& point_of_pixel, const std::vector<cv::Vec3f>& points,
                     const Camera& camera) {
  std::vector<double> offsets;
  for (const int point : point_of_pixel) {
    if (point < 0) continue;
    const cv::Point2d at = seen_at(points[std::size_t(point)], camera);
    offsets.push_back(std::hypot(at.x - std::round(at.x), at.y - std::round(at.y)));
  }
  if (offsets.empty()) return 0;
  const auto middle = offsets.begin() + std::ptrdiff_t(offsets.size() / 2);
  std::nth_element(offsets.begin(), middle, offsets.end());
  return *middle;
}

}  // namespace

cv::Mat_<float> depth_in_centres(const cv::Mat_<float>& depth, const std::vector<int>& point_of_pixel,
                                 const std::vector<cv::Vec3f>& points, const Camera& camera) {
  constexpr double centred = 0.05;      // pixels
  constexpr float one_surface = 0.04F;  // of the depth, between neighbours
  constexpr int fewest = 5;             // points of a plane
  if (median_offset(point_of_pixel, points, camera) < centred) return depth;
  cv::Mat_<float> result = depth.clone();
  for (int v = 1; v + 1 < depth.rows; ++v)
    for (int u = 1; u + 1 < depth.cols; ++u) {
      const float z = depth(v, u);
      if (!(z > 0)) continue;
      // The inverse depth of a plane is linear in the image.
      Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();
      Eigen::Vector3d products = Eigen::Vector3d::Zero();
      double low = 1 / double(z), high = low;
      int used = 0;
      for (int row = v - 1; row <= v + 1; ++row)
        for (int column = u - 1; column <= u + 1; ++column) {
          const float other = depth(row, column);
          if (!(std::abs(other - z) < one_surface * z)) continue;
          const cv::Point2d at =
              seen_at(points[std::size_t(point_of_pixel[std::size_t(row * depth.cols + column)])], camera);
          const Eigen::Vector3d terms(1, at.x - u, at.y - v);
          squares += terms * terms.transpose();
          products += terms / double(other);
          low = std::min(low, 1 / double(other)), high = std::max(high, 1 / double(other));
          ++used;
        }
      if (used < fewest) continue;
      const double inverse = squares.ldlt().solve(products)[0];
      if (inverse >= low && inverse <= high) result(v, u) = float(1 / inverse);
    }
  return result;
}

}  // namespace gestalt
