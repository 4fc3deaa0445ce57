// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_camera.h"

#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gestalt::synthesis {

cv::Mat measure_colour(const IdealView& view, Random& random) {
  cv::Mat_<cv::Vec3f> colour = view.colour.clone();
  for (cv::Vec3f& pixel : colour) {
    // Shot noise, most of it shared by the channels, on top of the noise of reading out.
    const float brightness = (pixel[0] + pixel[1] + pixel[2]) / 3;
    const float deviation = std::sqrt(4.f + 0.12f * brightness);
    const float shared = random.normal();
    for (int c = 0; c < 3; ++c) pixel[c] += deviation * (0.8f * shared + 0.6f * random.normal());
  }
  cv::Mat blurred, result;
  cv::GaussianBlur(colour, blurred, {}, 0.75);
  blurred.convertTo(result, CV_8U);
  return result;
}

}  // namespace gestalt::synthesis
