// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "collinearity.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace gestalt {

namespace {

constexpr double no_continuity = 2;
constexpr double no_occlusion = -1;

double distance_to_line(const Eigen::Vector3f& p, const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) {
  return double((p - origin).cross(direction).norm());
}

class CollinearityMeasure final : public Measure {
 public:
  CollinearityMeasure(const Scene& scene, const Collinearity::Params& params) : scene_(scene), params_(params) {
    const BoundaryLines& all = scene.boundary_lines();
    for (const LineLink& link : all.collinearities) {
      const BoundaryLine &from = all.lines[std::size_t(link.from)], &to = all.lines[std::size_t(link.to)];
      if (from.surface == to.surface) continue;
      const double continuity = this->continuity(from, to);
      Best& best = best_.try_emplace(std::minmax(from.surface, to.surface)).first->second;
      if (continuity < best.continuity) best = {continuity, occlusion(from, to)};
    }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const auto found = best_.find(std::minmax(pair.a, pair.b));
    const Best best = found != best_.end() ? found->second : Best{};
    values[0] = best.continuity;
    values[1] = best.occlusion;
  }

 private:
  struct Best {
    double continuity = no_continuity;
    double occlusion = no_occlusion;
  };

  /// Angle between the lines, in right angles, and distance of each end at the gap from the other line.
  double continuity(const BoundaryLine& from, const BoundaryLine& to) const {
    const Eigen::Vector3f x = (from.points[1] - from.points[0]).normalized();
    const Eigen::Vector3f y = (to.points[1] - to.points[0]).normalized();
    if (x.isZero() || y.isZero()) return no_continuity;
    const double angle = std::acos(std::clamp(double(x.dot(y)), -1.0, 1.0));
    const double distance =
        0.5 * (distance_to_line(to.points[0], from.points[1], x) + distance_to_line(from.points[1], to.points[0], y));
    return std::min(no_continuity, 2 / std::numbers::pi * angle + distance / params_.distance_scale);
  }

  /// How far what is seen across the gap lies in front of the line there, on average.
  double occlusion(const BoundaryLine& from, const BoundaryLine& to) const {
    const Frame& frame = scene_.frame();
    const auto pixel_at = [&](const Eigen::Vector3f& p) {
      return Eigen::Vector2f(float(p.x() / p.z() * frame.camera.fx + frame.camera.cx),
                             float(p.y() / p.z() * frame.camera.fy + frame.camera.cy));
    };
    const Eigen::Vector3f &start = from.points[1], &end = to.points[0];
    if (!(start.z() > 0 && end.z() > 0)) return no_occlusion;
    const int steps = std::clamp(int((pixel_at(end) - pixel_at(start)).norm()), 1, 256);
    double sum = 0;
    int count = 0;
    for (int i = 1; i < steps; ++i) {
      const Eigen::Vector3f p = start + float(i) / float(steps) * (end - start);
      const Eigen::Vector2f at = pixel_at(p);
      const int u = int(std::lround(at.x())), v = int(std::lround(at.y()));
      if (u < 0 || v < 0 || u >= frame.width() || v >= frame.height()) continue;
      const int label = scene_.surfaces().labels(v, u);
      if (frame.depth(v, u) <= 0 || label == from.surface + 1 || label == to.surface + 1) continue;
      sum += std::clamp(double(p.z() - frame.depth(v, u)), -1.0, 1.0);
      ++count;
    }
    return count > 0 ? sum / count : no_occlusion;
  }

  const Scene& scene_;
  const Collinearity::Params params_;
  std::map<std::pair<int, int>, Best> best_;
};

}  // namespace

const Parameters<Collinearity::Params>& Collinearity::parameters() {
  static const auto parameters =
      Parameters<Params>().real("distance_scale", &Params::distance_scale, 1e-4, 100, "m",
                                "offset of two lines that counts like a right angle between them");
  return parameters;
}

const std::vector<RelationValue>& Collinearity::values() const {
  static const std::vector<RelationValue> values{
      {"r_cs", 0, no_continuity,
       "continuity of boundary lines: angle (1 = right angle) + offset in 3D; 0 straight on, 2 without a collinearity"},
      {"r_oc", -1, 1, "mean depth in front of the line over the gap, m; > 0 occluder; -1 without a gap"}};
  return values;
}

std::unique_ptr<Measure> Collinearity::bind(const Scene& scene) const {
  return std::make_unique<CollinearityMeasure>(scene, params_);
}

}  // namespace gestalt
