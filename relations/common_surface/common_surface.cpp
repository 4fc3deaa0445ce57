// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

constexpr int samples = 24;

class CommonSurfaceMeasure final : public Measure {
 public:
  explicit CommonSurfaceMeasure(const Scene& scene) : surfaces_(scene.surfaces().surfaces) {
    for (const Outline& outline : scene.outlines())
      points_.emplace_back(outline.points(Eigen::all, spread_columns(outline, samples)));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::min(distance(pair.b, pair.a), distance(pair.a, pair.b));
  }

 private:
  /// Mean distance of the contour of a surface to another.
  double distance(int from, int to) const {
    const Eigen::Matrix3Xf& points = points_[std::size_t(from)];
    const SurfaceModel& model = *surfaces_[std::size_t(to)].model;
    double sum = 0;
    for (Eigen::Index i = 0; i < points.cols(); ++i) sum += std::sqrt(double(model.squared_distance(points.col(i))));
    return sum / double(points.cols());
  }

  const std::vector<Surface>& surfaces_;
  std::vector<Eigen::Matrix3Xf> points_;
};

}  // namespace

const Parameters<CommonSurface::Params>& CommonSurface::parameters() {
  static const Parameters<Params> parameters;
  return parameters;
}

const std::vector<RelationValue>& CommonSurface::values() const {
  static const std::vector<RelationValue> values{
      {"r_sp", 0, std::numeric_limits<double>::infinity(),
       "mean distance of a contour to the other's surface, m; the smaller of both ways"}};
  return values;
}

std::unique_ptr<Measure> CommonSurface::bind(const Scene& scene) const {
  return std::make_unique<CommonSurfaceMeasure>(scene);
}

}  // namespace gestalt
