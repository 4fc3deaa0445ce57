// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "minimum_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gestalt/core/scene/point_blocks.h"

namespace gestalt {

namespace {

class MinimumDistanceMeasure final : public Measure {
 public:
  explicit MinimumDistanceMeasure(const Scene& scene) {
    for (const Outline& outline : scene.outlines()) points_.emplace_back(outline.points);
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::sqrt(smallest_squared_distance(points_[std::size_t(std::min(pair.a, pair.b))],
                                                    points_[std::size_t(std::max(pair.a, pair.b))]));
  }

 private:
  std::vector<PointBlocks> points_;
};

}  // namespace

const Parameters<MinimumDistance::Params>& MinimumDistance::parameters() {
  static const Parameters<Params> parameters;
  return parameters;
}

const std::vector<RelationValue>& MinimumDistance::values() const {
  static const std::vector<RelationValue> values{
      {"r_md", 0, std::numeric_limits<double>::infinity(), "minimum distance between the contours of the patches, m"}};
  return values;
}

std::unique_ptr<Measure> MinimumDistance::bind(const Scene& scene) const {
  return std::make_unique<MinimumDistanceMeasure>(scene);
}

}  // namespace gestalt
