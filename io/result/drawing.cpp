// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "drawing.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "gestalt/io/result/result.h"

namespace gestalt {

cv::Vec3b segment_colour(int label) {
  // Hues a golden section apart: neighbouring numbers differ most.
  const double hue = std::fmod(label * 0.618033988749895, 1.0) * 6;
  const double value = label % 3 == 1 ? 0.75 : 1.0, saturation = label % 2 == 0 ? 0.65 : 0.9;
  const auto channel = [&](double offset) {
    const double k = std::fmod(hue + offset, 6.0);
    return std::uint8_t(255 * value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
  };
  return {channel(1), channel(3), channel(5)};
}

cv::Mat backdrop(const Frame& frame) {
  if (frame.has_colour()) return frame.colour;
  double nearest, farthest;
  cv::minMaxLoc(frame.depth, &nearest, &farthest, nullptr, nullptr, frame.depth > 0);
  cv::Mat grey, picture;
  frame.depth.convertTo(grey, CV_8U, -180 / std::max(farthest - nearest, 1e-6),
                        220 + 180 * nearest / std::max(farthest - nearest, 1e-6));
  grey.setTo(0, frame.depth == 0);
  cv::cvtColor(grey, picture, cv::COLOR_GRAY2BGR);
  return picture;
}

cv::Mat draw_patches(const cv::Mat_<int>& labels) {
  cv::Mat picture(labels.size(), CV_8UC3, cv::Scalar::all(0));
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (labels(v, u) > 0) picture.at<cv::Vec3b>(v, u) = segment_colour(labels(v, u));
  return picture;
}

cv::Mat draw_normals(const cv::Mat_<cv::Vec3f>& normals) {
  cv::Mat picture(normals.size(), CV_8UC3, cv::Scalar::all(0));
  for (int v = 0; v < normals.rows; ++v)
    for (int u = 0; u < normals.cols; ++u) {
      const cv::Vec3f n = normals(v, u);
      if (n != cv::Vec3f()) {
        const auto channel = [](float value) { return cv::saturate_cast<std::uint8_t>(255 * value); };
        picture.at<cv::Vec3b>(v, u) = {channel(-n[2]), channel((n[1] + 1) / 2), channel((n[0] + 1) / 2)};
      }
    }
  return picture;
}

cv::Mat_<cv::Vec3f> surface_normals(const Frame& frame, const SurfaceSet& surfaces) {
  cv::Mat_<cv::Vec3f> normals(surfaces.labels.size(), cv::Vec3f());
  for (const Surface& surface : surfaces.surfaces)
    for (const int pixel : surface.pixels) {
      const Eigen::Vector3f normal = surface.model->foot(frame.point(pixel)).normal;
      normals(pixel / normals.cols, pixel % normals.cols) = {normal.x(), normal.y(), normal.z()};
    }
  return normals;
}

}  // namespace gestalt
