// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contour_continuity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gestalt/core/scene/angle.h"

namespace gestalt {

namespace {

class ContourContinuityMeasure final : public Measure {
 public:
  ContourContinuityMeasure(const Scene& scene, double share) : outlines_(scene.outlines()), share_(share) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const Outline& a = outlines_[std::size_t(std::min(pair.a, pair.b))];
    const Outline& b = outlines_[std::size_t(std::max(pair.a, pair.b))];
    Sums sums;
    add_nearest(a, b, sums);
    add_nearest(b, a, sums);
    values[0] = std::min(sums.angle / sums.count, std::numbers::pi);
    values[1] = sums.distance / sums.count;
  }

 private:
  struct Sums {
    double angle = 0;
    double distance = 0;
    double count = 0;
  };

  void add_nearest(const Outline& from, const Outline& to, Sums& sums) const {
    for (const NearestPoint& n : nearest_points(from.points, to.points, share_)) {
      const Eigen::Vector3f normal = from.normals.col(n.from), other = to.normals.col(n.to);
      const Eigen::Vector3f gap = to.points.col(n.to) - from.points.col(n.from);
      sums.angle += double(angle_between(normal, other));
      sums.distance += double(std::abs(normal.dot(gap)) + std::abs(other.dot(gap))) / 2;
      sums.count += 1;
    }
  }

  const std::vector<Outline>& outlines_;
  const double share_;
};

}  // namespace

const Parameters<ContourContinuity::Params>& ContourContinuity::parameters() {
  static const auto parameters = Parameters<Params>().real("share", &Params::share, 1e-6, 1, "",
                                                           "share of each patch's contour points, the nearest ones");
  return parameters;
}

const std::vector<RelationValue>& ContourContinuity::values() const {
  static const std::vector<RelationValue> values{
      {"r_ac", 0, std::numbers::pi, "mean angle between the normals of the nearest contour points, rad"},
      {"r_dn", 0, std::numeric_limits<double>::infinity(),
       "mean distance in normal direction of the nearest contour points, m"}};
  return values;
}

std::unique_ptr<Measure> ContourContinuity::bind(const Scene& scene) const {
  return std::make_unique<ContourContinuityMeasure>(scene, params_.share);
}

}  // namespace gestalt
