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
        inverse0_(inverse_depth(from, i)),
        inverse1_(inverse_depth(to, j)),
        width_(width) {}

  /// Of an end, in 1 / metres.
  static float inverse_depth(const Outline& outline, int i) { return 1 / std::max(outline.points(2, i), nearest); }

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
  friend class PixelWalk;
  static constexpr float nearest = 1e-3f;  // m; a fitted surface may pass behind the camera

  int u0_, v0_, u1_, v1_;
  float inverse0_, inverse1_;
  int width_;
};

/// The pixels of a line for s = 1, 2, ..., as HypothesisedLine::pixel() gives them, without its divisions.
class PixelWalk {
 public:
  /// steps at least 1.
  PixelWalk(const HypothesisedLine& line, int steps)
      : u_(line.u0_, line.u1_, steps), v_(line.v0_, line.v1_, steps), width_(line.width_) {}

  /// That of the next s.
  int next() { return v_.next() * width_ + u_.next(); }

 private:
  /// One coordinate, as a whole number and what is left over in parts of 2 * steps.
  class Coordinate {
   public:
    Coordinate(int from, int to, int steps)
        : at_(from),
          step_((to - from) / steps - ((to - from) % steps < 0)),
          rest_(2 * (to - from - step_ * steps)),
          left_over_(steps),
          whole_(2 * steps) {}

    int next() {
      left_over_ += rest_;
      const bool carry = left_over_ >= whole_;
      left_over_ -= carry ? whole_ : 0;
      return at_ += step_ + carry;
    }

   private:
    int at_, step_, rest_, left_over_, whole_;
  };

  Coordinate u_, v_;
  int width_;
};

/// Difference of a measured depth that is level with a line at depth z: within slack metres and three standard
/// deviations of the sensor's noise.
inline float sight_tolerance(const DepthNoise& noise, float z, double slack) {
  return float(slack + 3 * noise.at(double(z)));
}

/// What is seen at a pixel where a line is expected at depth z.
inline Sight sight(const Frame& frame, int pixel, float z, double slack) {
  const float measured = frame.depth.ptr<float>()[pixel];
  if (!(measured > 0)) return Sight::unknown;
  const float tolerance = sight_tolerance(frame.noise, z, slack);
  if (measured < z - tolerance) return Sight::front;
  return measured > z + tolerance ? Sight::behind : Sight::level;
}

}  // namespace gestalt
