// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gap_occlusion.h"

#include <algorithm>
#include <array>

#include "gestalt/core/base/wide.h"
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

/// Of the pixels of a line: its depth there, and from where to where a measured depth is level with it.
struct LevelDepths {
  std::array<float, most_pixels + 1> line, nearest, farthest;
};

// What the loop does not change are its own copies, so that the compiler sees that it does not.
GESTALT_WIDE void find_level_depths(HypothesisedLine line, int steps, DepthNoise noise, double slack,
                                    LevelDepths& level) {
  float* const __restrict depth = level.line.data();
  float* const __restrict nearest = level.nearest.data();
  float* const __restrict farthest = level.farthest.data();
  for (int s = 1; s < steps; ++s) {
    const float z = line.depth(s, steps), tolerance = sight_tolerance(noise, z, slack);
    depth[s] = z;
    nearest[s] = z - tolerance;
    farthest[s] = z + tolerance;
  }
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
    const float* depth = frame_.depth.ptr<float>();
    LevelDepths level;
    for (const NearestPoint& ends : nearest_points(pixels_[f], pixels_[t], params_.share)) {
      const HypothesisedLine line(outlines_[f], ends.from, outlines_[t], ends.to, frame_.width());
      const int steps = std::min(line.length(), most_pixels + 1);
      if (steps < 2) continue;
      find_level_depths(line, steps, frame_.noise, params_.slack, level);
      const double weight = 1.0 / (steps - 1);
      PixelWalk walk(line, steps);
      for (std::size_t s = 1; s < std::size_t(steps); ++s) {
        const int pixel = walk.next(), label = labels[pixel];
        if (label == from + 1 || label == to + 1) continue;
        sums.weight += weight;
        const float measured = depth[pixel];
        if (!(measured > 0)) continue;
        if (measured >= level.nearest[s] && measured <= level.farthest[s]) sums.level += weight;
        sums.difference += weight * std::clamp(double(level.line[s] - measured), -params_.limit, params_.limit);
      }
    }
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
