// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "minimum_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

class MinimumDistanceMeasure final : public Measure {
 public:
  explicit MinimumDistanceMeasure(const Scene& scene) : outlines_(scene.outlines()) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const Eigen::Matrix3Xf& a = outlines_[std::size_t(std::min(pair.a, pair.b))].points;
    const Eigen::Matrix3Xf& b = outlines_[std::size_t(std::max(pair.a, pair.b))].points;
    const SquaredDistances distances_to(b);
    Eigen::ArrayXf distances(b.cols());
    float nearest = std::numeric_limits<float>::infinity();
    for (Eigen::Index i = 0; i < a.cols(); ++i) {
      distances_to(a.col(i), distances);
      nearest = std::min(nearest, distances.minCoeff());
    }
    values[0] = std::sqrt(nearest);
  }

 private:
  const std::vector<Outline>& outlines_;
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
