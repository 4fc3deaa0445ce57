// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_edges.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

namespace gestalt {

namespace {

/// CIELAB, smoothed; lightness in [0, 100].
cv::Mat_<cv::Vec3f> smoothed_lab(const cv::Mat& colour, double smoothing) {
  cv::Mat bytes;
  cv::cvtColor(colour, bytes, cv::COLOR_BGR2Lab);
  cv::Mat_<cv::Vec3f> lab;
  bytes.convertTo(lab, CV_32FC3);
  lab.forEach([](cv::Vec3f& pixel, const int*) { pixel[0] *= 100.f / 255; });
  cv::GaussianBlur(lab, lab, {}, smoothing);
  return lab;
}

}  // namespace

ColourEdges find_colour_edges(const cv::Mat& colour, double smoothing) {
  const cv::Mat_<cv::Vec3f> lab = smoothed_lab(colour, smoothing);
  cv::Mat_<cv::Vec3f> across, down;
  constexpr double weight = 1. / 8;  // of Sobel's masks
  cv::Sobel(lab, across, CV_32F, 1, 0, 3, weight);
  cv::Sobel(lab, down, CV_32F, 0, 1, 3, weight);
  cv::Mat_<float> strength(colour.size());
  ColourEdges edges{cv::Mat_<float>(colour.size(), 0.f), cv::Mat_<float>(colour.size())};
  tbb::parallel_for(0, colour.rows, [&](int v) {
    for (int u = 0; u < colour.cols; ++u) {
      const cv::Vec3f &x = across(v, u), &y = down(v, u);
      const float xx = x.dot(x), xy = x.dot(y), yy = y.dot(y);
      const float half_difference = (xx - yy) / 2;
      strength(v, u) = std::sqrt((xx + yy) / 2 + std::sqrt(half_difference * half_difference + xy * xy));
      const float direction = std::atan2(2 * xy, xx - yy) / 2;
      edges.direction(v, u) = direction < 0 ? direction + std::numbers::pi_v<float> : direction;
    }
  });
  tbb::parallel_for(1, colour.rows - 1, [&](int v) {
    for (int u = 1; u + 1 < colour.cols; ++u) {
      const float turn = edges.direction(v, u);
      const int du = int(std::lround(std::cos(turn))), dv = int(std::lround(std::sin(turn)));
      // Of two equal ones, the second.
      if (strength(v, u) > strength(v + dv, u + du) && strength(v, u) >= strength(v - dv, u - du))
        edges.strength(v, u) = strength(v, u);
    }
  });
  return edges;
}

}  // namespace gestalt
