// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hull_view.h"

#include <algorithm>
#include <array>
#include <optional>

#include "gestalt/core/base/wide.h"
#include "gestalt/core/scene/hypothesised_line.h"

namespace gestalt {

namespace {

constexpr int line_ends = 12, line_pixels = 10, line_steps = line_pixels + 1;
constexpr int most_pixels = line_ends * line_pixels;  // of the lines from one end

/// Over a line as its diameter.
struct Sphere {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float squared_radius = -1;

  bool contains(const Eigen::Vector3f& p) const { return (p - centre).squaredNorm() <= squared_radius; }
};

/// What the pixels of lines are added up of: of each line's end and each of the line's pixels, one after the other, the
/// part that the end has in the place of the pixel and in the inverse of its depth (HypothesisedLine).
struct LineParts {
  std::array<int, most_pixels> u, v;
  std::array<float, most_pixels> inverse;
  int count = 0;
};

/// The parts of the ends of a surface when the lines go to them.
LineParts parts_of(const Outline& outline, const std::vector<int>& ends, int width) {
  LineParts parts;
  for (const int end : ends) {
    const int pixel = outline.pixels[std::size_t(end)];
    for (int s = 1; s < line_steps; ++s) {
      const auto i = std::size_t(parts.count++);
      parts.u[i] = 2 * (pixel % width) * s;
      parts.v[i] = 2 * (pixel / width) * s;
      parts.inverse[i] = HypothesisedLine::inverse_depth(outline, end) * float(s);
    }
  }
  return parts;
}

/// The parts of one end, by number, when lines go from it to so many pixels: the same for each line.
void repeat_reversed(const LineParts& ends, int end, int count, LineParts& parts) {
  for (std::size_t i = 0; i < line_pixels; ++i) {
    const std::size_t own = std::size_t((end + 1) * line_pixels) - 1 - i;
    parts.u[i] = ends.u[own] + line_steps;  // for rounding
    parts.v[i] = ends.v[own] + line_steps;
    parts.inverse[i] = ends.inverse[own];
  }
  for (auto at = std::size_t{line_pixels}; at < std::size_t(count); at += line_pixels) {
    std::copy_n(parts.u.begin(), line_pixels, parts.u.begin() + at);
    std::copy_n(parts.v.begin(), line_pixels, parts.v.begin() + at);
    std::copy_n(parts.inverse.begin(), line_pixels, parts.inverse.begin() + at);
  }
  parts.count = count;
}

/// Pixels of lines, where each lies and what is level with it.
struct LinePixels {
  std::array<int, most_pixels> index;
  std::array<float, most_pixels> nearest, farthest;  // level depths
};

// What the loop does not change are its own copies, so that the compiler sees that it does not.
GESTALT_WIDE void place(const LineParts& from, const LineParts& to, int width, DepthNoise noise, double slack,
                        LinePixels& pixels) {
  const int count = to.count;
  const int *from_u = from.u.data(), *from_v = from.v.data(), *to_u = to.u.data(), *to_v = to.v.data();
  const float *from_inverse = from.inverse.data(), *to_inverse = to.inverse.data();
  int* const __restrict index = pixels.index.data();
  float* const __restrict nearest = pixels.nearest.data();
  float* const __restrict farthest = pixels.farthest.data();
  for (int i = 0; i < count; ++i) {
    const unsigned u = unsigned(from_u[i] + to_u[i]) / unsigned(2 * line_steps);
    const unsigned v = unsigned(from_v[i] + to_v[i]) / unsigned(2 * line_steps);
    index[i] = int(v) * width + int(u);
  }
  for (int i = 0; i < count; ++i) {
    const float z = float(line_steps) / (from_inverse[i] + to_inverse[i]);
    const float tolerance = sight_tolerance(noise, z, slack);
    nearest[i] = z - tolerance;
    farthest[i] = z + tolerance;
  }
}

/// What is seen at them.
struct Sights {
  std::array<float, most_pixels> depth;
  std::array<int, most_pixels> label;
  std::array<int, most_pixels> is_behind;  // of another surface
};

struct Counts {
  int behind = 0, hollow = 0, front = 0;
};

GESTALT_WIDE Counts count(const LinePixels& pixels, int size, int a, int b, Sights& sights) {
  int behind = 0, hollow = 0, front = 0;
  for (int i = 0; i < size; ++i) {
    const float depth = sights.depth[std::size_t(i)];
    const int own = int(sights.label[std::size_t(i)] == a) | int(sights.label[std::size_t(i)] == b);
    const int is_behind = depth > pixels.farthest[std::size_t(i)];
    const int is_front = int(depth < pixels.nearest[std::size_t(i)]) & int(depth > 0);
    sights.is_behind[std::size_t(i)] = is_behind & ~own;
    behind += is_behind & ~own;
    hollow += is_behind & own;
    front += is_front & ~own;
  }
  return {behind, hollow, front};
}

class HullViewMeasure final : public Measure {
 public:
  HullViewMeasure(const Scene& scene, double slack)
      : frame_(scene.frame()), labels_(scene.surfaces().labels), outlines_(scene.outlines()), slack_(slack) {
    for (const Outline& outline : outlines_) {
      ends_.push_back(spread_columns(outline, line_ends));
      parts_.push_back(parts_of(outline, ends_.back(), frame_.width()));
    }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const int a = std::min(pair.a, pair.b), b = std::max(pair.a, pair.b);
    const LineParts& to = parts_[std::size_t(b)];
    const float* depth = frame_.depth.ptr<float>();
    const int* label = labels_.ptr<int>();
    std::optional<Sphere> around;
    Counts sums;
    int outside = 0, size = 0;
    LineParts from;
    LinePixels pixels;
    Sights sights;
    for (std::size_t end = 0; end < ends_[std::size_t(a)].size(); ++end) {
      repeat_reversed(parts_[std::size_t(a)], int(end), to.count, from);
      place(from, to, frame_.width(), frame_.noise, slack_, pixels);
      for (std::size_t i = 0; i < std::size_t(to.count); ++i) {
        sights.depth[i] = depth[pixels.index[i]];
        sights.label[i] = label[pixels.index[i]];
      }
      const Counts counts = count(pixels, to.count, a + 1, b + 1, sights);
      size += to.count;
      sums.behind += counts.behind;
      sums.hollow += counts.hollow;
      sums.front += counts.front;
      if (counts.behind == 0) continue;
      if (!around) around = sphere(a, b);
      for (std::size_t i = 0; i < std::size_t(to.count); ++i)
        if (sights.is_behind[i] && !around->contains(frame_.point(pixels.index[i]))) ++outside;
    }
    values[0] = double(sums.behind) / size;
    values[1] = double(outside) / size;
    values[2] = sums.behind + sums.front > 0 ? double(sums.behind) / (sums.behind + sums.front) : 0.0;
    values[3] = double(sums.hollow) / size;
  }

 private:
  Sphere sphere(int a, int b) const {
    const Eigen::Matrix3Xf &points_a = outlines_[std::size_t(a)].points, &points_b = outlines_[std::size_t(b)].points;
    Sphere largest;
    for (const int i : ends_[std::size_t(a)])
      for (const int j : ends_[std::size_t(b)])
        if (const float d = (points_a.col(i) - points_b.col(j)).squaredNorm() / 4; d > largest.squared_radius)
          largest = {(points_a.col(i) + points_b.col(j)) / 2, d};
    return largest;
  }

  const Frame& frame_;
  const cv::Mat_<int>& labels_;
  const std::vector<Outline>& outlines_;
  const double slack_;
  std::vector<std::vector<int>> ends_;
  std::vector<LineParts> parts_;
};

}  // namespace

const Parameters<HullView::Params>& HullView::parameters() {
  static const auto parameters = Parameters<Params>().real(
      "slack", &Params::slack, 0, 1, "m", "difference of depth, beyond noise, that is still level with a line");
  return parameters;
}

const std::vector<RelationValue>& HullView::values() const {
  static const std::vector<RelationValue> values{
      {"r_hb", 0, 1, "share of the common hull where another surface is seen behind it"},
      {"r_ho", 0, 1, "share of the common hull where another surface is seen far behind, outside of its sphere"},
      {"r_hn", 0, 1, "other surfaces behind the common hull, to those behind and in front; 0 without any"},
      {"r_hh", 0, 1, "share of the common hull that one of the patches hollows out"}};
  return values;
}

std::unique_ptr<Measure> HullView::bind(const Scene& scene) const {
  return std::make_unique<HullViewMeasure>(scene, params_.slack);
}

}  // namespace gestalt
