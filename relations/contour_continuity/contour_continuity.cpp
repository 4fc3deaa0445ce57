// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contour_continuity.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "gestalt/angle.h"

namespace gestalt {

namespace {

/// A point of one outline with the nearest point of the other.
struct Nearest {
  float squared_distance = std::numeric_limits<float>::infinity();
  int from = 0;
  int to = 0;

  bool operator<(const Nearest& other) const {
    return squared_distance != other.squared_distance ? squared_distance < other.squared_distance : from < other.from;
  }
};

std::vector<Nearest> nearest_points(const Outline& from, const Outline& to) {
  std::vector<Nearest> nearest(from.pixels.size());
  Eigen::RowVectorXf distances(to.points.cols());
  for (Eigen::Index i = 0; i < from.points.cols(); ++i) {
    distances.noalias() = (to.points.colwise() - from.points.col(i)).colwise().squaredNorm();
    const float smallest = distances.minCoeff();
    const auto j = std::find(distances.begin(), distances.end(), smallest) - distances.begin();
    nearest[std::size_t(i)] = {smallest, int(i), int(j)};
  }
  return nearest;
}

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
    std::vector<Nearest> nearest = nearest_points(from, to);
    const auto kept = std::ptrdiff_t(std::ceil(share_ * double(nearest.size())));
    std::nth_element(nearest.begin(), nearest.begin() + kept - 1, nearest.end());
    for (auto n = nearest.begin(); n != nearest.begin() + kept; ++n) {
      const Eigen::Vector3f normal = from.normals.col(n->from), other = to.normals.col(n->to);
      const Eigen::Vector3f gap = to.points.col(n->to) - from.points.col(n->from);
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
