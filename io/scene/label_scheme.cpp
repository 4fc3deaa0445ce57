// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "label_scheme.h"

#include <algorithm>
#include <map>
#include <set>

#include "gestalt/core/base/error.h"

namespace gestalt {

std::optional<LabelScheme> guess_scheme(const cv::Mat_<int>& labels, const cv::Mat& measured) {
  constexpr double some = 0.02, most = 0.5;  // shares of the measured pixels
  std::map<int, int> pixels;
  int all = 0;
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (measured.at<std::uint8_t>(v, u)) ++pixels[labels(v, u)], ++all;
  if (all == 0) return LabelScheme::osd;

  // In the scheme of the OSD the table is 1 to 9 and no label is from 10 to 19; where objects are counted it is 0.
  const double zeros = pixels.contains(0) ? double(pixels[0]) / all : 0;
  int low = 0, teens = 0, high = 0;
  double low_share = 0;
  bool tens = true;
  std::set<int> decades;
  for (const auto& [label, count] : pixels) {
    if (label <= 0) continue;
    if (label < 10) {
      ++low;
      low_share += double(count) / all;
    } else if (label < 20) {
      ++teens;
    } else {
      ++high;
      tens = tens && label % 10 == 0;
      decades.insert(label / 10);
    }
  }
  if (teens > 0) return zeros > some ? std::optional(LabelScheme::objects) : std::nullopt;
  if (high == 0) {
    if (low == 0 || (low == 1 && zeros < most)) return LabelScheme::osd;  // without an object
    return zeros > some ? std::optional(LabelScheme::objects) : std::nullopt;
  }
  if (low > 0) {
    if (zeros < some || tens || low_share >= std::max(zeros, 0.2)) return LabelScheme::osd;
    return std::nullopt;
  }
  if ((tens && high > 1) || zeros < some) return LabelScheme::osd;
  // Numbers of different tens are different objects in both.
  return decades.size() == std::size_t(high) ? std::optional(LabelScheme::objects) : std::nullopt;
}

cv::Mat_<std::uint16_t> labels_of_numbers(const cv::Mat_<int>& objects, const cv::Mat& measured) {
  constexpr int most = 6552;  // 10 (6552 + 1) is the largest multiple of ten in 16 bits
  std::map<int, int> order;
  int largest = 0;
  for (const int object : objects) {
    largest = std::max(largest, object);
    if (object > 0) order.emplace(object, 0);
  }
  if (order.size() > std::size_t(most))
    throw InputError("has " + std::to_string(order.size()) + " objects; at most " + std::to_string(most) +
                     " are supported");
  int next = 0;
  for (auto& [object, number] : order) number = largest > most ? ++next : object;
  cv::Mat_<std::uint16_t> labels(objects.size(), std::uint16_t{0});
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols; ++u)
      if (measured.at<std::uint8_t>(v, u))
        labels(v, u) = std::uint16_t(objects(v, u) <= 0 ? 1 : 10 * (order.at(objects(v, u)) + 1));
  return labels;
}

}  // namespace gestalt
