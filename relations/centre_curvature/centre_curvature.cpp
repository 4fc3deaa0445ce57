// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "centre_curvature.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gestalt/core/scene/angle.h"

namespace gestalt {

namespace {

constexpr std::size_t samples = 256;

struct Facing {
  Eigen::Vector3f centre;
  Eigen::Vector3f normal;  ///< not of unit length
};

/// Mean point and normal of at most 256 evenly spread pixels.
Facing facing_of(const Frame& frame, const Surface& surface) {
  const std::size_t step = (surface.pixels.size() + samples - 1) / samples;
  Eigen::Vector3f points = Eigen::Vector3f::Zero(), normals = Eigen::Vector3f::Zero();
  float count = 0;
  for (std::size_t i = 0; i < surface.pixels.size(); i += step) {
    const SurfaceModel::Foot foot = surface.model->foot(frame.point(surface.pixels[i]));
    points += foot.point;
    normals += foot.normal;
    count += 1;
  }
  return {points / count, normals / count};
}

class CentreCurvatureMeasure final : public Measure {
 public:
  explicit CentreCurvatureMeasure(const Scene& scene) {
    for (const Surface& surface : scene.surfaces().surfaces) facings_.push_back(facing_of(scene.frame(), surface));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const Facing& a = facings_[std::size_t(std::min(pair.a, pair.b))];
    const Facing& b = facings_[std::size_t(std::max(pair.a, pair.b))];
    const Eigen::Vector3f d = b.centre - a.centre;
    values[0] = values[1] = 0;
    if (!(d.norm() > 0)) return;
    constexpr double pi = std::numbers::pi;
    const double at_a = angle_between(a.normal, d), at_b = angle_between(b.normal, -d);
    values[0] = std::clamp(at_a + at_b - pi, -pi, pi);
    values[1] = std::min(std::abs(at_a - at_b), pi);
  }

 private:
  std::vector<Facing> facings_;
};

}  // namespace

const Parameters<CentreCurvature::Params>& CentreCurvature::parameters() {
  static const Parameters<Params> parameters;
  return parameters;
}

const std::vector<RelationValue>& CentreCurvature::values() const {
  static const std::vector<RelationValue> values{
      {"r_cc", -std::numbers::pi, std::numbers::pi,
       "curvature from centre to centre, rad; > 0 facing apart, < 0 facing each other, 0 parallel or centres equal"},
      {"r_cd", 0, std::numbers::pi, "rad; 0 for patches beside one another, pi for one straight behind the other"}};
  return values;
}

std::unique_ptr<Measure> CentreCurvature::bind(const Scene& scene) const {
  return std::make_unique<CentreCurvatureMeasure>(scene);
}

}  // namespace gestalt
