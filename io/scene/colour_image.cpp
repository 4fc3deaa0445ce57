// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_image.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace gestalt {

namespace {

/// An image of 1, 3 or 4 channels as one of 3; unlike cv::cvtColor(), of any type of numbers.
cv::Mat in_three_channels(const cv::Mat& image) {
  if (image.channels() == 3) return image;
  const bool grey = image.channels() == 1;
  cv::Mat three(image.size(), CV_MAKETYPE(image.depth(), 3));
  cv::mixChannels(image, three, grey ? std::vector<int>{0, 0, 0, 1, 0, 2} : std::vector<int>{0, 0, 1, 1, 2, 2});
  return three;
}

}  // namespace

cv::Mat as_colour(const cv::Mat& image, std::string& problem) {
  const int channels = image.channels();
  if (channels != 1 && channels != 3 && channels != 4) {
    problem = "has " + std::to_string(channels) + " channels; colour has 1, 3 or 4";
    return {};
  }
  cv::Mat colour = in_three_channels(image);
  if (colour.depth() == CV_8U) return colour;

  const cv::Mat values = colour.reshape(1);
  double low = 0, high = 0;
  cv::minMaxIdx(values, &low, &high);
  const double mean = cv::mean(values)[0];
  const bool whole = colour.depth() != CV_32F && colour.depth() != CV_64F;
  const double largest = whole ? (high > 255 ? 65535 : 255) : (mean > 1 ? 255 : 1);
  // Renderers have highlights above 1, filters go a little below 0.
  const bool fits = whole || largest == 255 ? high <= largest : !std::isnan(mean);
  if (!(low >= (whole ? 0 : -0.05 * largest)) || !fits) {  // or not a number
    problem = "has values from " + std::to_string(low) + " to " + std::to_string(high) +
              "; colour is from 0 to 1 or from 0 to 255 (floats), or from 0 to 65535 (whole numbers)";
    return {};
  }
  colour.convertTo(colour, CV_8U, 255 / largest);
  return colour;
}

cv::Mat resized(const cv::Mat& colour, cv::Size size) {
  cv::Mat result;
  cv::resize(colour, result, size, 0, 0, colour.cols > size.width ? cv::INTER_AREA : cv::INTER_LINEAR);
  return result;
}

bool same_aspect(cv::Size a, cv::Size b) {
  if (a.width > b.width) std::swap(a, b);
  return std::abs(double(b.height) * a.width / b.width - a.height) <= std::max(0.5, 0.005 * a.height);
}

}  // namespace gestalt
