// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "depth_jumps.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <opencv2/imgproc.hpp>

namespace gestalt::synthesis {

cv::Mat_<uchar> beside_jumps(const cv::Mat_<float>& depth, int radius) {
  const cv::Mat box = cv::getStructuringElement(cv::MORPH_RECT, {2 * radius + 1, 2 * radius + 1});
  cv::Mat lowest, highest;
  cv::erode(depth, lowest, box);
  cv::dilate(depth, highest, box);
  // A plane seen at 60 degrees changes by 0.003 of its depth per pixel: no jump.
  return highest - lowest > 0.02 * highest;
}

namespace {

/// The mean along the rows (du, dv = 1, 0) or columns (0, 1).
cv::Mat_<float> mean_along(const cv::Mat_<float>& values, int du, int dv, int radius, float tolerance) {
  cv::Mat_<float> means(values.size(), 0.f);
  const auto step = std::ptrdiff_t(values.step1()) * dv + du;
  for (int v = 0; v < values.rows; ++v)
    for (int u = 0; u < values.cols; ++u) {
      const float* const centre = &values(v, u);
      const float own = *centre;
      if (own == 0) continue;
      const int before = du * u + dv * v, after = du * (values.cols - 1 - u) + dv * (values.rows - 1 - v);
      float sum = 0;
      int count = 0;
      for (int i = -std::min(radius, before); i <= std::min(radius, after); ++i) {
        const float value = centre[i * step];
        if (value == 0 || std::abs(value - own) >= tolerance) continue;
        sum += value;
        ++count;
      }
      means(v, u) = sum / float(count);
    }
  return means;
}

}  // namespace

cv::Mat_<float> window_mean(const cv::Mat_<float>& values, int radius, float tolerance) {
  return mean_along(mean_along(values, 1, 0, radius, tolerance), 0, 1, radius, tolerance);
}

}  // namespace gestalt::synthesis
