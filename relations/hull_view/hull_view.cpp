// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hull_view.h"

#include <algorithm>
#include <limits>

#include "gestalt/core/scene/hypothesised_line.h"

namespace gestalt {

namespace {

constexpr int line_ends = 12, line_pixels = 10;

/// Over a line as its diameter.
struct Sphere {
  Eigen::Vector3f centre = Eigen::Vector3f::Zero();
  float squared_radius = -1;

  bool contains(const Eigen::Vector3f& p) const { return (p - centre).squaredNorm() <= squared_radius; }
};

class HullViewMeasure final : public Measure {
 public:
  HullViewMeasure(const Scene& scene, double slack)
      : frame_(scene.frame()), labels_(scene.surfaces().labels), outlines_(scene.outlines()), slack_(slack) {
    for (const Outline& outline : outlines_) ends_.push_back(spread_columns(outline, line_ends));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const int a = std::min(pair.a, pair.b), b = std::max(pair.a, pair.b);
    const Sphere around = sphere(a, b);
    double behind = 0, outside = 0, front = 0, hollow = 0, count = 0;
    for (const int i : ends_[std::size_t(a)])
      for (const int j : ends_[std::size_t(b)]) {
        const HypothesisedLine line(outlines_[std::size_t(a)], i, outlines_[std::size_t(b)], j, frame_.width());
        constexpr int steps = line_pixels + 1;
        for (int s = 1; s < steps; ++s) {
          const int pixel = line.pixel(s, steps), label = labels_(pixel);
          const bool own = label == a + 1 || label == b + 1;
          const Sight seen = sight(frame_, pixel, line.depth(s, steps), slack_);
          count += 1;
          if (seen == Sight::behind) {
            (own ? hollow : behind) += 1;
            if (!own && !around.contains(frame_.point(pixel))) outside += 1;
          }
          if (seen == Sight::front && !own) front += 1;
        }
      }
    values[0] = behind / count;
    values[1] = outside / count;
    values[2] = behind + front > 0 ? behind / (behind + front) : 0.0;
    values[3] = hollow / count;
  }

 private:
  Sphere sphere(int a, int b) const {
    const Eigen::Matrix3Xf &points_a = outlines_[std::size_t(a)].points, &points_b = outlines_[std::size_t(b)].points;
    Sphere largest;
    for (const int i : ends_[std::size_t(a)])
      for (const int j : ends_[std::size_t(b)])
        if (const float d = (points_a.col(i) - points_b.col(j)).squaredNorm() / 4; d > largest.squared_radius)
          largest = {(points_a.col(i) + points_b.col(j)) / 2, d};
    return largest;
  }

  const Frame& frame_;
  const cv::Mat_<int>& labels_;
  const std::vector<Outline>& outlines_;
  const double slack_;
  std::vector<std::vector<int>> ends_;
};

}  // namespace

const Parameters<HullView::Params>& HullView::parameters() {
  static const auto parameters = Parameters<Params>().real(
      "slack", &Params::slack, 0, 1, "m", "difference of depth, beyond noise, that is still level with a line");
  return parameters;
}

const std::vector<RelationValue>& HullView::values() const {
  static const std::vector<RelationValue> values{
      {"r_hb", 0, 1, "share of the common hull where another surface is seen behind it"},
      {"r_ho", 0, 1, "share of the common hull where another surface is seen far behind, outside of its sphere"},
      {"r_hn", 0, 1, "other surfaces behind the common hull, to those behind and in front; 0 without any"},
      {"r_hh", 0, 1, "share of the common hull that one of the patches hollows out"}};
  return values;
}

std::unique_ptr<Measure> HullView::bind(const Scene& scene) const {
  return std::make_unique<HullViewMeasure>(scene, params_.slack);
}

}  // namespace gestalt
