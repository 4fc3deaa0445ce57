// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "support_height.h"

#include <algorithm>
#include <limits>

namespace {

/// Mean height of every patch over the largest one, in [0, highest].
std::vector<double> heights_over_support(const gestalt::Scene& scene, double highest) {
  const auto& surfaces = scene.surfaces().surfaces;
  const auto smaller = [](const auto& x, const auto& y) { return x.pixels.size() < y.pixels.size(); };
  const gestalt::SurfaceModel& support = *std::max_element(surfaces.begin(), surfaces.end(), smaller)->model;
  std::vector<double> heights;
  for (const gestalt::Surface& surface : surfaces) {
    double sum = 0;
    for (const int pixel : surface.pixels) {
      const Eigen::Vector3f point = scene.frame().point(pixel);
      const auto foot = support.foot(point);
      sum += (point - foot.point).dot(foot.normal);
    }
    heights.push_back(std::clamp(sum / double(surface.pixels.size()), 0.0, highest));
  }
  return heights;
}

class SupportHeightMeasure final : public gestalt::Measure {
 public:
  explicit SupportHeightMeasure(std::vector<double> heights) : heights_(std::move(heights)) {}
  void operator()(const gestalt::SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::min(heights_[std::size_t(pair.a)], heights_[std::size_t(pair.b)]);
  }

 private:
  std::vector<double> heights_;
};

}  // namespace

const gestalt::Parameters<SupportHeight::Params>& SupportHeight::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>().real("highest", &Params::highest, 0.01, 10, "m", "greater heights count as this");
  return parameters;
}

const std::vector<gestalt::RelationValue>& SupportHeight::values() const {
  static const std::vector<gestalt::RelationValue> values{
      {"r_sh", 0, 10, "smaller mean height of the two patches over the largest patch of the scene, m"}};
  return values;
}

std::unique_ptr<gestalt::Measure> SupportHeight::bind(const gestalt::Scene& scene) const {
  return std::make_unique<SupportHeightMeasure>(heights_over_support(scene, params_.highest));
}
