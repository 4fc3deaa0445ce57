// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cstdlib>

#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/outline.h"

namespace gestalt {

/// What a frame shows where a line would be seen.
enum class Sight {
  unknown,  ///< no depth was measured
  front,    ///< something nearer covers the line
  level,    ///< something is where the line is
  behind    ///< the line would hide what is seen: nothing is there
};

/// The straight line in space from a point of one outline to a point of another, walked in the image.
class HypothesisedLine {
 public:
  HypothesisedLine(const Outline& from, int i, const Outline& to, int j, int width)
      : u0_(from.pixels[std::size_t(i)] % width),
        v0_(from.pixels[std::size_t(i)] / width),
        u1_(to.pixels[std::size_t(j)] % width),
        v1_(to.pixels[std::size_t(j)] / width),
        inverse0_(1 / std::max(from.points(2, i), nearest)),
        inverse1_(1 / std::max(to.points(2, j), nearest)),
        width_(width) {}

  /// Pixels from end to end, the larger of columns and rows.
  int length() const { return std::max(std::abs(u1_ - u0_), std::abs(v1_ - v0_)); }

  /// Pixel at s / steps of the way, 0 <= s <= steps; the same when the line is walked from the other end.
  int pixel(int s, int steps) const {
    const auto between = [&](int x0, int x1) { return (2 * (x0 * (steps - s) + x1 * s) + steps) / (2 * steps); };
    return between(v0_, v1_) * width_ + between(u0_, u1_);
  }

  /// Depth of the line there, metres: its inverse is linear in the image.
  float depth(int s, int steps) const { return float(steps) / (inverse0_ * float(steps - s) + inverse1_ * float(s)); }

 private:
  static constexpr float nearest = 1e-3f;  // m; a fitted surface may pass behind the camera

  int u0_, v0_, u1_, v1_;
  float inverse0_, inverse1_;
  int width_;
};

/// What is seen at a pixel where a line is expected at depth z. A measured depth within slack metres and three standard
/// deviations of the sensor's noise is level.
inline Sight sight(const Frame& frame, int pixel, float z, double slack) {
  const float measured = frame.depth.ptr<float>()[pixel];
  if (!(measured > 0)) return Sight::unknown;
  const auto tolerance = float(slack + 3 * frame.noise.at(double(z)));
  if (measured < z - tolerance) return Sight::front;
  return measured > z + tolerance ? Sight::behind : Sight::level;
}

}  // namespace gestalt
