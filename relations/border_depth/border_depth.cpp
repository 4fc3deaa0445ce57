// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_depth.h"

#include <cmath>
#include <limits>

namespace gestalt {

namespace {

class BorderDepthMeasure final : public Measure {
 public:
  explicit BorderDepthMeasure(const Frame& frame) : depth_(frame.depth.ptr<float>()) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = values[1] = 0;
    if (!pair.border) return;
    const auto count = double(pair.border->border_2d.size());
    for (const PixelPair& touching : pair.border->border_2d) values[0] += step(touching) / count;
    for (const PixelPair& touching : pair.border->border_2d)
      values[1] += std::pow(step(touching) - values[0], 2) / count;
  }

 private:
  double step(const PixelPair& p) const { return std::abs(double(depth_[p.a]) - double(depth_[p.b])); }

  const float* depth_;
};

}  // namespace

const Parameters<BorderDepth::Params>& BorderDepth::parameters() {
  static const Parameters<Params> none;
  return none;
}

const std::vector<RelationValue>& BorderDepth::values() const {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  static const std::vector<RelationValue> values{
      {"r_di2", 0, infinity, "mean depth difference over the 2D border, m; 0 without a border"},
      {"r_vd2", 0, infinity, "variance of that difference, m^2; 0 without a border"}};
  return values;
}

std::unique_ptr<Measure> BorderDepth::bind(const Scene& scene) const {
  return std::make_unique<BorderDepthMeasure>(scene.frame());
}

}  // namespace gestalt
