// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "ground_truth.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <vector>

namespace gestalt::synthesis {

namespace {

constexpr int tear = 20;           // millimetres
constexpr std::size_t speck = 20;  // pixels

using Part = std::vector<cv::Point>;

Part grow(cv::Point seed, const cv::Mat_<std::uint16_t>& depth, const cv::Mat_<int>& body, cv::Mat_<uchar>& taken) {
  const cv::Rect image({0, 0}, depth.size());
  Part part{seed};
  taken(seed) = 1;
  for (std::size_t i = 0; i < part.size(); ++i) {
    const cv::Point here = part[i];
    for (const cv::Point& step : {cv::Point(1, 0), cv::Point(-1, 0), cv::Point(0, 1), cv::Point(0, -1)}) {
      const cv::Point next = here + step;
      if (!image.contains(next) || taken(next) || !depth(next) || body(next) != body(here)) continue;
      if (std::abs(int(depth(next)) - int(depth(here))) > tear) continue;
      taken(next) = 1;
      part.push_back(next);
    }
  }
  return part;
}

}  // namespace

cv::Mat_<std::uint16_t> label_parts(const cv::Mat_<std::uint16_t>& depth, const cv::Mat_<int>& body) {
  cv::Mat_<uchar> taken(depth.size(), uchar(0));
  std::map<int, std::vector<Part>> parts_of;
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      if (depth(v, u) && !taken(v, u)) parts_of[std::max(body(v, u), 0)].push_back(grow({u, v}, depth, body, taken));

  cv::Mat_<std::uint16_t> labels(depth.size(), std::uint16_t(0));
  for (auto& [thing, parts] : parts_of) {
    std::stable_sort(parts.begin(), parts.end(), [](const Part& a, const Part& b) { return a.size() > b.size(); });
    const int first = thing == 0 ? 1 : 10 * (thing + 1), last = thing == 0 ? 9 : first + 9;
    for (std::size_t i = 0; i < parts.size(); ++i)
      for (const cv::Point& pixel : parts[i])
        labels(pixel) = std::uint16_t(parts[i].size() < speck ? first : std::min(first + int(i), last));
  }
  return labels;
}

}  // namespace gestalt::synthesis
