// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "input_picture.h"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "gestalt/io/scene/png_codec.h"

namespace gestalt::app {

namespace {

/// The depths between which the colours lie: without the nearest and the farthest hundredth, which are noise.
std::pair<float, float> depth_range(const Frame& frame) {
  std::vector<float> depths;
  std::copy_if(frame.depth.begin(), frame.depth.end(), std::back_inserter(depths), [](float d) { return d > 0; });
  std::sort(depths.begin(), depths.end());
  const std::size_t tail = depths.size() / 100;
  return {depths[tail], depths[depths.size() - 1 - tail]};
}

cv::Mat depth_in_colours(const Frame& frame) {
  const auto [near, far] = depth_range(frame);
  cv::Mat_<std::uint8_t> shades(frame.depth.size());
  for (int v = 0; v < shades.rows; ++v)
    for (int u = 0; u < shades.cols; ++u)
      shades(v, u) = cv::saturate_cast<std::uint8_t>(255 * (far - frame.depth(v, u)) / std::max(far - near, 1e-6f));
  cv::Mat colours;
  cv::applyColorMap(shades, colours, cv::COLORMAP_TURBO);
  colours.setTo(cv::Scalar::all(0), frame.depth <= 0);
  return colours;
}

}  // namespace

std::string input_picture(const Frame& frame) {
  constexpr int most_columns = 640;
  const cv::Mat colour = frame.has_colour() ? frame.colour : cv::Mat(frame.depth.size(), CV_8UC3, cv::Scalar::all(128));
  cv::Mat both;
  cv::hconcat(colour, depth_in_colours(frame), both);
  if (frame.width() > most_columns) {
    const double scale = double(most_columns) / frame.width();
    cv::resize(both, both, {}, scale, scale, cv::INTER_AREA);
  }
  return encode_png(both);
}

}  // namespace gestalt::app
