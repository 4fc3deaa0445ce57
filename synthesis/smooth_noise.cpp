// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "smooth_noise.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

namespace gestalt::synthesis {

cv::Mat_<float> smooth_noise(cv::Size size, double radius, Random& random) {
  cv::Mat_<float> noise(size);
  for (float& value : noise) value = random.normal();
  cv::GaussianBlur(noise, noise, {}, radius, radius, cv::BORDER_REFLECT_101);
  // A Gaussian of deviation r divides the variance of white noise by 4 pi r^2.
  return noise * (2 * std::sqrt(CV_PI) * radius);
}

cv::Mat_<float> broad_noise(cv::Size size, double radius, Random& random) {
  const double step = std::max(1.0, radius / 2);  // a grid on which the noise's radius is 2
  const cv::Size coarse(int(std::ceil(size.width / step)) + 1, int(std::ceil(size.height / step)) + 1);
  cv::Mat_<float> noise;
  cv::resize(smooth_noise(coarse, radius / step, random), noise, size, 0, 0, cv::INTER_CUBIC);
  return noise;
}

float exceeded_with(double probability) {
  const double p = std::clamp(probability, 1e-4, 1 - 1e-4);
  return float(std::log((1 - p) / p) / 1.702);
}

}  // namespace gestalt::synthesis
