// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "joint_extent.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

constexpr int samples = 48;

class JointExtentMeasure final : public Measure {
 public:
  explicit JointExtentMeasure(const Scene& scene) {
    for (const Outline& outline : scene.outlines())
      points_.emplace_back(outline.points(Eigen::all, spread_columns(outline, samples)));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const Eigen::Matrix3Xf& a = points_[std::size_t(std::min(pair.a, pair.b))];
    const Eigen::Matrix3Xf& b = points_[std::size_t(std::max(pair.a, pair.b))];
    const SquaredDistances distances_to(b);
    Eigen::ArrayXf distances(b.cols());
    float farthest = 0;
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
      distances_to(a.col(i), distances);
      farthest = std::max(farthest, distances.maxCoeff());
    }
    values[0] = std::sqrt(farthest);
  }

 private:
  std::vector<Eigen::Matrix3Xf> points_;
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
