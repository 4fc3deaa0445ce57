// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mean_normals.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "gestalt/core/scene/angle.h"

namespace gestalt {

namespace {

// Variance that normals in single precision may have though they are equal.
constexpr double rounding = 1e-6;

struct Normals {
  Eigen::Vector3f mean;
  double variance;
};

Eigen::Vector3f measured(const Scene& scene, int pixel) {
  const cv::Vec3f& n = scene.patches().normals.ptr<cv::Vec3f>()[pixel];
  return {n[0], n[1], n[2]};
}

Normals normals_of(const Scene& scene, const Surface& surface, const MeanNormals::Params& params) {
  const std::size_t step = (surface.pixels.size() + std::size_t(params.samples) - 1) / std::size_t(params.samples);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double squares = 0, count = 0;
  for (std::size_t i = 0; i < surface.pixels.size(); i += step) {
    const int pixel = surface.pixels[i];
    const Eigen::Vector3f normal =
        params.normals == "measured" ? measured(scene, pixel) : surface.model->foot(scene.frame().point(pixel)).normal;
    sum += normal.cast<double>();
    squares += double(normal.squaredNorm());
    count += 1;
  }
  const Eigen::Vector3d mean = sum / count;
  const double variance = squares / count - mean.squaredNorm();
  return {mean.cast<float>(), variance < rounding ? 0.0 : std::min(variance, 1.0)};
}

class MeanNormalsMeasure final : public Measure {
 public:
  MeanNormalsMeasure(const Scene& scene, const MeanNormals::Params& params)
      : normals_(scene.surfaces().surfaces.size()) {
    tbb::parallel_for(std::size_t{0}, normals_.size(),
                      [&](std::size_t i) { normals_[i] = normals_of(scene, scene.surfaces().surfaces[i], params); });
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    const Normals& a = normals_[std::size_t(std::min(pair.a, pair.b))];
    const Normals& b = normals_[std::size_t(std::max(pair.a, pair.b))];
    values[0] = std::min<double>(angle_between(a.mean, b.mean), std::numbers::pi);
    values[1] = std::abs(a.variance - b.variance);
  }

 private:
  std::vector<Normals> normals_;
};

}  // namespace

const Parameters<MeanNormals::Params>& MeanNormals::parameters() {
  static const auto parameters =
      Parameters<Params>()
          .choice("normals", &Params::normals, {"fitted", "measured"},
                  "normals of the fitted surfaces, or those that the clusterer measured")
          .integer("samples", &Params::samples, 1, 1000000, "px", "pixels of a patch looked at, evenly spread over it");
  return parameters;
}

const std::vector<RelationValue>& MeanNormals::values() const {
  static const std::vector<RelationValue> values{
      {"r_nm", 0, std::numbers::pi, "angle between the mean normals, rad; 0 for a patch whose normals cancel out"},
      {"r_nv", 0, 1, "difference of the variances of the normals; a plane has 0"}};
  return values;
}

std::unique_ptr<Measure> MeanNormals::bind(const Scene& scene) const {
  return std::make_unique<MeanNormalsMeasure>(scene, params_);
}

}  // namespace gestalt
