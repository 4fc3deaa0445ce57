// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_cuts.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "colour_edges.h"

namespace gestalt {

namespace {

constexpr int directions = 36;  // of lines
constexpr double direction_step = std::numbers::pi / directions;
constexpr double smoothing = 1;              // px
constexpr double largest_turn = 0.45;        // rad, of an edge to the line that it supports
constexpr std::size_t most_candidates = 40;  // lines of a patch that are looked at closely

/// Those of normal . (u, v) = offset, in pixels.
struct Line {
  double normal_u, normal_v, offset;
};

/// A part of a patch: its pixels within a box of the image.
struct Part {
  cv::Rect box;
  cv::Mat_<std::uint8_t> mask;  // 1 in the part
  int size = 0;
};

/// The same with the box as small as it can be. The part has pixels.
Part trimmed(const Part& part) {
  const cv::Rect within = cv::boundingRect(part.mask);
  return {within + part.box.tl(), part.mask(within).clone(), part.size};
}

class Cutting {
 public:
  Cutting(const Frame& frame, const ColourCutParams& params)
      : frame_(frame),
        edges_(find_colour_edges(frame.colour, smoothing)),
        contrast_(float(params.cut_contrast)),
        share_(params.cut_share),
        longest_(params.longest_cut) {
    const double scale = std::sqrt(pixel_density(frame.camera));
    shortest_ = std::max(2, int(std::lround(params.cut_length * scale)));
    narrowest_ = params.cut_width * scale;
    reach_ = std::max(1, int(std::lround(2 * scale)));
  }

  /// The parts of a patch, at least one.
  std::vector<Part> cut(Part whole) const {
    std::vector<Part> open{std::move(whole)}, done;
    while (!open.empty()) {
      Part part = trimmed(open.back());
      open.pop_back();
      const std::optional<Line> line = best_line(part);
      if (!line) {
        done.push_back(std::move(part));
        continue;
      }
      auto [one, other] = split(part, *line);
      open.push_back(std::move(other));
      open.push_back(std::move(one));
    }
    return done;
  }

 private:
  float strength(const Part& part, int u, int v) const { return edges_.strength(part.box.y + v, part.box.x + u); }
  float direction(const Part& part, int u, int v) const { return edges_.direction(part.box.y + v, part.box.x + u); }

  /// The line that most edge pixels follow, of those that may cut the part.
  std::optional<Line> best_line(const Part& part) const {
    if (part.size < 2 * narrowest_ * shortest_) return std::nullopt;
    std::optional<Line> best;
    int best_support = 0;
    for (const Line& line : candidates(part)) {
      const Support support = support_of(line, part);
      if (support.supported <= best_support || !leaves_enough(line, support.length, part)) continue;
      best = line;
      best_support = support.supported;
    }
    return best;
  }

  /// Lines by the votes of the edge pixels inside the part (Hough), most votes first.
  std::vector<Line> candidates(const Part& part) const {
    const int width = part.mask.cols, height = part.mask.rows;
    const int farthest = int(std::hypot(width, height)) + 2, offsets = 2 * farthest + 1;
    cv::Mat_<float> votes(directions, offsets, 0.f);
    int voters = 0;
    for (int v = 1; v + 1 < height; ++v)
      for (int u = 1; u + 1 < width; ++u) {
        if (!part.mask(v, u) || strength(part, u, v) <= contrast_ || !inside(part.mask, u, v)) continue;
        ++voters;
        const float vote = std::min(1.f, strength(part, u, v) / (2 * contrast_));
        const int own = int(std::lround(double(direction(part, u, v)) / direction_step));
        for (int turn = -1; turn <= 1; ++turn) {
          const int k = (own + turn + directions) % directions;
          const auto [c, s] = unit(k);
          votes(k, int(std::lround(u * c + v * s)) + farthest) += vote;
        }
      }
    if (voters < share_ * shortest_) return {};
    return peaks(votes, farthest);
  }

  /// Whether all neighbours are in the part as well: an edge of its outline cuts nothing.
  static bool inside(const cv::Mat_<std::uint8_t>& mask, int u, int v) {
    for (int y = v - 1; y <= v + 1; ++y)
      if (!mask(y, u - 1) || !mask(y, u) || !mask(y, u + 1)) return false;
    return true;
  }

  static std::pair<double, double> unit(int k) {
    static const auto table = [] {
      std::array<std::pair<double, double>, directions> all;
      for (int i = 0; i < directions; ++i)
        all[std::size_t(i)] = {std::cos(i * direction_step), std::sin(i * direction_step)};
      return all;
    }();
    return table[std::size_t(k)];
  }

  std::vector<Line> peaks(const cv::Mat_<float>& votes, int farthest) const {
    const int offsets = votes.cols;
    std::vector<std::pair<float, int>> sums;  // of neighbouring offsets; negative, so that the first is the largest
    for (int k = 0; k < directions; ++k)
      for (int r = 0; r < offsets; ++r) {
        float sum = 0;
        for (int q = std::max(0, r - reach_); q <= std::min(offsets - 1, r + reach_); ++q) sum += votes(k, q);
        if (sum >= 0.4f * float(shortest_)) sums.emplace_back(-sum, k * offsets + r);
      }
    const std::size_t most = std::min(most_candidates, sums.size());
    std::partial_sort(sums.begin(), sums.begin() + std::ptrdiff_t(most), sums.end());
    std::vector<std::pair<int, int>> taken;
    std::vector<Line> lines;
    for (std::size_t i = 0; i < most; ++i) {
      const int k = sums[i].second / offsets, r = sums[i].second % offsets;
      if (std::any_of(taken.begin(), taken.end(), [&](const auto& other) {
            return std::abs(k - other.first) <= 1 && std::abs(r - other.second) <= reach_;
          }))
        continue;
      taken.emplace_back(k, r);
      const auto [c, s] = unit(k);
      lines.push_back({c, s, double(r - farthest)});
    }
    return lines;
  }

  struct Support {
    int length = 0;  // pixels of the line in the part
    int supported =
        0;  // those beside an edge; 0 where they are too small a share, or the line is too short or too long
  };

  Support support_of(const Line& line, const Part& part) const {
    const int width = part.mask.cols, height = part.mask.rows;
    const int farthest = int(std::hypot(width, height)) + 2;
    const double angle = std::atan2(line.normal_v, line.normal_u);
    int length = 0, supported = 0;
    std::optional<int> first, last;  // pixels of the image
    for (int t = -farthest; t <= farthest; ++t) {
      const double u = line.offset * line.normal_u - t * line.normal_v,
                   v = line.offset * line.normal_v + t * line.normal_u;
      const int own_u = int(std::lround(u)), own_v = int(std::lround(v));
      if (own_u < 0 || own_v < 0 || own_u >= width || own_v >= height || !part.mask(own_v, own_u)) continue;
      ++length;
      last = (part.box.y + own_v) * frame_.width() + part.box.x + own_u;
      if (!first) first = last;
      for (int q = -reach_; q <= reach_; ++q) {
        const int near_u = int(std::lround(u + q * line.normal_u)), near_v = int(std::lround(v + q * line.normal_v));
        if (near_u < 0 || near_v < 0 || near_u >= width || near_v >= height) continue;
        if (strength(part, near_u, near_v) <= contrast_) continue;
        const double turn = std::abs(double(direction(part, near_u, near_v)) - angle);
        if (std::min(turn, std::numbers::pi - turn) > largest_turn) continue;
        ++supported;
        break;
      }
    }
    if (length < shortest_ || supported < share_ * length ||
        (frame_.point(*first) - frame_.point(*last)).norm() > float(longest_))
      return {};
    return {length, supported};
  }

  static bool beyond(const Line& line, int u, int v) { return u * line.normal_u + v * line.normal_v > line.offset; }

  bool leaves_enough(const Line& line, int length, const Part& part) const {
    int count = 0;
    for (int v = 0; v < part.mask.rows; ++v)
      for (int u = 0; u < part.mask.cols; ++u) count += part.mask(v, u) && beyond(line, u, v);
    return std::min(count, part.size - count) >= narrowest_ * length;
  }

  static std::pair<Part, Part> split(const Part& part, const Line& line) {
    std::pair<Part, Part> parts{{part.box, part.mask, 0}, {part.box, part.mask.clone(), 0}};
    for (int v = 0; v < part.mask.rows; ++v)
      for (int u = 0; u < part.mask.cols; ++u) {
        if (!part.mask(v, u)) continue;
        const bool second = beyond(line, u, v);
        (second ? parts.first : parts.second).mask(v, u) = 0;
        ++(second ? parts.second : parts.first).size;
      }
    return parts;
  }

  const Frame& frame_;
  const ColourEdges edges_;
  const float contrast_;
  const double share_, longest_;
  double narrowest_;      // px
  int shortest_, reach_;  // px
};

/// Every patch as one part.
std::vector<Part> parts_of(const LabelledPatches& patches) {
  std::vector<cv::Rect> boxes(std::size_t(patches.count));
  std::vector<int> sizes(boxes.size(), 0);
  const cv::Mat_<int>& labels = patches.labels;
  for (int v = 0; v < labels.rows; ++v)
    for (int u = 0; u < labels.cols;) {
      const int label = labels(v, u), begin = u;
      while (u < labels.cols && labels(v, u) == label) ++u;
      if (label == 0) continue;
      boxes[std::size_t(label) - 1] |= cv::Rect(begin, v, u - begin, 1);
      sizes[std::size_t(label) - 1] += u - begin;
    }
  std::vector<Part> parts(boxes.size());
  tbb::parallel_for(std::size_t{0}, parts.size(), [&](std::size_t i) {
    parts[i] = {boxes[i], (labels(boxes[i]) == int(i) + 1) & 1, sizes[i]};
  });
  return parts;
}

}  // namespace

CutPatches cut_along_colour_edges(const Frame& frame, const LabelledPatches& patches, const ColourCutParams& params) {
  const Cutting cutting(frame, params);
  std::vector<Part> wholes = parts_of(patches);
  std::vector<std::vector<Part>> parts(wholes.size());
  tbb::parallel_for(std::size_t{0}, wholes.size(),
                    [&](std::size_t i) { parts[i] = cutting.cut(std::move(wholes[i])); });
  CutPatches result{{patches.labels, patches.count}, std::vector<int>(parts.size())};
  std::iota(result.grown.begin(), result.grown.end(), 1);
  for (std::size_t i = 0; i < parts.size(); ++i)
    for (std::size_t k = 1; k < parts[i].size(); ++k) {
      result.patches.labels(parts[i][k].box).setTo(++result.patches.count, parts[i][k].mask);
      result.grown.push_back(int(i) + 1);
    }
  return result;
}

}  // namespace gestalt
