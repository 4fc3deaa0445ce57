// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "joint_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gestalt/core/scene/point_blocks.h"

namespace gestalt {

namespace {

constexpr int samples = 48;

class JointExtentMeasure final : public Measure {
 public:
  explicit JointExtentMeasure(const Scene& scene) {
    for (const Outline& outline : scene.outlines())
      points_.emplace_back(Eigen::Matrix3Xf(outline.points(Eigen::all, spread_columns(outline, samples))));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::sqrt(largest_squared_distance(points_[std::size_t(std::min(pair.a, pair.b))],
                                                   points_[std::size_t(std::max(pair.a, pair.b))]));
  }

 private:
  std::vector<PointBlocks> points_;
};

}  // namespace

const Parameters<JointExtent::Params>& JointExtent::parameters() {
  static const Parameters<Params> parameters;
  return parameters;
}

const std::vector<RelationValue>& JointExtent::values() const {
  static const std::vector<RelationValue> values{
      {"r_ex", 0, std::numeric_limits<double>::infinity(), "largest distance between the contours of the patches, m"}};
  return values;
}

std::unique_ptr<Measure> JointExtent::bind(const Scene& scene) const {
  return std::make_unique<JointExtentMeasure>(scene);
}

}  // namespace gestalt
