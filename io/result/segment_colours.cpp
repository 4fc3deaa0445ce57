// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "segment_colours.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <set>

namespace gestalt {

namespace {

/// A colour in OKLab, in which distances are about as large as they look (Ottosson 2020).
using Lab = std::array<double, 3>;

double apart(const Lab& a, const Lab& b) { return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]); }

cv::Vec3b to_bgr(const Lab& lab) {
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(lab[0] + 0.3963377774 * lab[1] + 0.2158037573 * lab[2]);
  const double m = cube(lab[0] - 0.1055613458 * lab[1] - 0.0638541728 * lab[2]);
  const double s = cube(lab[0] - 0.0894841775 * lab[1] - 1.291485548 * lab[2]);
  const auto byte = [](double linear) {
    const double x = linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
    return cv::saturate_cast<std::uint8_t>(255 * x);
  };
  return {byte(-0.0041960863 * l - 0.7034186147 * m + 1.707614701 * s),
          byte(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          byte(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s)};
}

constexpr double clearly_different = 0.25;  // the most distant colours of the palette are 0.38 apart

/// Twelve hues, each light and dark.
std::vector<Lab> palette() {
  constexpr int hues = 12;
  std::vector<Lab> colours;
  for (const double lightness : {0.72, 0.52})
    for (int i = 0; i < hues; ++i) {
      const double hue = 2 * std::numbers::pi * i / hues;
      colours.push_back({lightness, 0.16 * std::cos(hue), 0.16 * std::sin(hue)});
    }
  return colours;
}

/// Of each label, the labels that are in the same row, column or diagonal at most 8 pixels away.
std::vector<std::set<int>> neighbours(const cv::Mat_<std::uint16_t>& labels, std::size_t count) {
  std::vector<std::set<int>> near(count + 1);
  for (const int step : {1, 2, 4, 8})
    for (const cv::Point direction : {cv::Point(1, 0), cv::Point(0, 1), cv::Point(1, 1), cv::Point(-1, 1)})
      for (int v = 0; v + step * direction.y < labels.rows; ++v)
        for (int u = direction.x < 0 ? step : 0; u + step * std::max(direction.x, 0) < labels.cols; ++u) {
          const int one = labels(v, u), other = labels(v + step * direction.y, u + step * direction.x);
          if (one == other || one == 0 || other == 0) continue;
          near[std::size_t(one)].insert(other);
          near[std::size_t(other)].insert(one);
        }
  return near;
}

}  // namespace

std::vector<cv::Vec3b> segment_colours(const Segmentation& segmentation) {
  const std::vector<Lab> colours = palette();
  const std::size_t count = segmentation.segments.size();
  const std::vector<std::set<int>> near = neighbours(segmentation.labels, count);

  constexpr int none = -1;
  std::vector<int> chosen(count, none);
  std::vector<int> uses(colours.size(), 0);
  for (std::size_t i = 0; i < count; ++i) {
    if (segmentation.segments[i].role != Role::object) continue;
    double best = -std::numeric_limits<double>::infinity();
    for (std::size_t c = 0; c < colours.size(); ++c) {
      double nearest = clearly_different;
      for (const int label : near[i + 1])
        if (const int other = chosen[std::size_t(label) - 1]; other != none)
          nearest = std::min(nearest, apart(colours[c], colours[std::size_t(other)]));
      double to_any = 2 * clearly_different;
      for (std::size_t other = 0; other < colours.size(); ++other)
        if (uses[other] > 0) to_any = std::min(to_any, apart(colours[c], colours[other]));
      // Unlike the neighbours first; then one that is seldom used, and unlike all others.
      const double score = nearest - 0.02 * uses[c] + 0.1 * to_any;
      if (score > best) best = score, chosen[i] = int(c);
    }
    ++uses[std::size_t(chosen[i])];
  }

  std::vector<cv::Vec3b> result(count);
  for (std::size_t i = 0; i < count; ++i)
    if (chosen[i] != none) result[i] = to_bgr(colours[std::size_t(chosen[i])]);
  return result;
}

}  // namespace gestalt
