// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "rectification.h"

#include <cmath>
#include <cstring>

namespace gestalt {

Rectification::Rectification(const Lens& lens, const Camera& camera) : seen_in_(camera.height, camera.width, -1) {
  const double known = lens.largest_radius(largest_radius_of(camera));
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const cv::Point2d ray((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
      if (std::hypot(ray.x, ray.y) > known) continue;
      const cv::Point2d seen = lens.distorted(ray);
      const double column = std::floor(seen.x * camera.fx + camera.cx + 0.5),
                   row = std::floor(seen.y * camera.fy + camera.cy + 0.5);
      if (column >= 0 && column < camera.width && row >= 0 && row < camera.height)
        seen_in_(v, u) = int(row) * camera.width + int(column);
    }
}

cv::Mat Rectification::operator()(const cv::Mat& image) const {
  cv::Mat result = cv::Mat::zeros(image.size(), image.type());
  for (int v = 0; v < image.rows; ++v)
    for (int u = 0; u < image.cols; ++u)
      if (const int from = seen_in_(v, u); from >= 0)
        std::memcpy(result.ptr(v, u), image.ptr(from / image.cols, from % image.cols), image.elemSize());
  return result;
}

}  // namespace gestalt
