// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "closure.h"

#include <algorithm>
#include <map>

namespace gestalt {

namespace {

/// Length of every surface's contours without the lines where something else than the surface ends them.
std::vector<double> own_boundaries(const Scene& scene) {
  std::vector<double> lengths;
  for (const std::vector<Contour>& contours : scene.contours()) {
    double& length = lengths.emplace_back(0);
    for (const Contour& contour : contours) length += double(contour.pixels.size());
  }
  for (const BoundaryLine& line : scene.boundary_lines().lines)
    if (!line.own()) lengths[std::size_t(line.surface)] -= line.support;
  return lengths;
}

class ClosureMeasure final : public Measure {
 public:
  explicit ClosureMeasure(const Scene& scene) {
    const std::vector<double> boundaries = own_boundaries(scene);
    const auto line_support = [&](const Closure::Part& part) {
      return std::min(1.0, part.line_length / std::max(1.0, boundaries[std::size_t(part.surface)]));
    };
    for (const Closure& closure : scene.closures())
      for (std::size_t i = 0; i < closure.parts.size(); ++i)
        for (std::size_t j = i + 1; j < closure.parts.size(); ++j) {
          const Closure::Part &a = closure.parts[i], &b = closure.parts[j];
          Best& best = best_[{a.surface, b.surface}];
          best.lines = std::max(best.lines, (line_support(a) + line_support(b)) / 2);
          best.area = std::max(best.area, share(scene, a, b));
          best.gaps = std::min(best.gaps, double(closure.gap_length / (closure.gap_length + closure.line_length)));
        }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const auto found = best_.find(std::minmax(pair.a, pair.b));
    const Best best = found != best_.end() ? found->second : Best{};
    values[0] = best.lines;
    values[1] = best.area;
    values[2] = best.gaps;
  }

 private:
  struct Best {
    double lines = 0;
    double area = 0;
    double gaps = 1;
  };

  static double share(const Scene& scene, const Closure::Part& a, const Closure::Part& b) {
    const auto size = [&](const Closure::Part& part) {
      return double(scene.surfaces().surfaces[std::size_t(part.surface)].pixels.size());
    };
    return std::min(1.0, (a.inside * size(a) + b.inside * size(b)) / (size(a) + size(b)));
  }

  std::map<std::pair<int, int>, Best> best_;
};

}  // namespace

const Parameters<ClosureRelation::Params>& ClosureRelation::parameters() {
  static const Parameters<Params> none;
  return none;
}

const std::vector<RelationValue>& ClosureRelation::values() const {
  static const std::vector<RelationValue> values{
      {"r_ls", 0, 1, "share of the patches' own boundaries in a closed contour, mean of both; 0 without one"},
      {"r_as", 0, 1, "share of the patches' pixels that a closed contour encloses; 0 without one"},
      {"r_lg", 0, 1, "share of gaps in a closed contour; 1 without one"}};
  return values;
}

std::unique_ptr<Measure> ClosureRelation::bind(const Scene& scene) const {
  return std::make_unique<ClosureMeasure>(scene);
}

}  // namespace gestalt
