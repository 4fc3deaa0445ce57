// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gap_occlusion.h"

#include <algorithm>

#include "gestalt/core/scene/hypothesised_line.h"
#include "gestalt/core/scene/point_blocks.h"

namespace gestalt {

namespace {

constexpr int most_pixels = 32;

Eigen::Matrix3Xf in_image(const Outline& outline, int width) {
  Eigen::Matrix3Xf pixels(3, outline.points.cols());
  for (Eigen::Index i = 0; i < pixels.cols(); ++i) {
    const int pixel = outline.pixels[std::size_t(i)];
    pixels.col(i) << float(pixel % width), float(pixel / width), 0;
  }
  return pixels;
}

class GapOcclusionMeasure final : public Measure {
 public:
  GapOcclusionMeasure(const Scene& scene, const GapOcclusion::Params& params)
      : frame_(scene.frame()), labels_(scene.surfaces().labels), outlines_(scene.outlines()), params_(params) {
    for (const Outline& outline : outlines_) pixels_.emplace_back(in_image(outline, frame_.width()));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    Sums sums;
    add_lines(std::min(pair.a, pair.b), std::max(pair.a, pair.b), sums);
    add_lines(std::max(pair.a, pair.b), std::min(pair.a, pair.b), sums);
    values[0] = sums.weight > 0 ? std::clamp(sums.difference / sums.weight, -params_.limit, params_.limit) : 0.0;
    values[1] = sums.weight > 0 ? std::clamp(sums.level / sums.weight, 0.0, 1.0) : 0.0;
  }

 private:
  struct Sums {
    double difference = 0;
    double level = 0;
    double weight = 0;
  };

  void add_lines(int from, int to, Sums& sums) const {
    const std::size_t f = std::size_t(from), t = std::size_t(to);
    const int* labels = labels_.ptr<int>();
    for (const NearestPoint& ends : nearest_points(pixels_[f], pixels_[t], params_.share)) {
      const HypothesisedLine line(outlines_[f], ends.from, outlines_[t], ends.to, frame_.width());
      const int steps = std::min(line.length(), most_pixels + 1);
      if (steps < 2) continue;
      const double weight = 1.0 / (steps - 1);
      PixelWalk walk(line, steps);
      for (int s = 1; s < steps; ++s) {
        const int pixel = walk.next(), label = labels[pixel];
        if (label != from + 1 && label != to + 1) add(pixel, line.depth(s, steps), weight, sums);
      }
    }
  }

  void add(int pixel, float z, double weight, Sums& sums) const {
    sums.weight += weight;
    const Sight seen = sight(frame_, pixel, z, params_.slack);
    if (seen == Sight::unknown) return;
    if (seen == Sight::level) sums.level += weight;
    const double difference = double(z - frame_.depth.ptr<float>()[pixel]);
    sums.difference += weight * std::clamp(difference, -params_.limit, params_.limit);
  }

  const Frame& frame_;
  const cv::Mat_<int>& labels_;
  const std::vector<Outline>& outlines_;
  const GapOcclusion::Params params_;
  std::vector<PointBlocks> pixels_;
};

}  // namespace

const Parameters<GapOcclusion::Params>& GapOcclusion::parameters() {
  static const auto parameters =
      Parameters<Params>()
          .real("share", &Params::share, 1e-6, 1, "", "share of each patch's lines to the other, the shortest")
          .real("limit", &Params::limit, 0.001, 10, "m", "larger differences of depth count as this")
          .real("slack", &Params::slack, 0, 1, "m", "difference of depth, beyond noise, that is still level");
  return parameters;
}

const std::vector<RelationValue>& GapOcclusion::values() const {
  static const std::vector<RelationValue> values{
      {"r_go", -10, 10,
       "mean depth of the lines across the gap minus measured depth, m; > 0 occluded, < 0 open, 0 without a gap"},
      {"r_gl", 0, 1, "share of the gap where a third surface lies level with the lines; 0 without a gap"}};
  return values;
}

std::unique_ptr<Measure> GapOcclusion::bind(const Scene& scene) const {
  return std::make_unique<GapOcclusionMeasure>(scene, params_);
}

}  // namespace gestalt
