// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_curvature.h"

#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <numbers>
#include <vector>

namespace gestalt {

namespace {

/// A patch near a border pixel.
struct Support {
  Eigen::Vector3f centre;
  Eigen::Vector3f normal;
};

/// How many pixels from each on, to the right, have its label; at most 255.
cv::Mat_<std::uint8_t> runs_of(const cv::Mat_<int>& labels) {
  constexpr int most = std::numeric_limits<std::uint8_t>::max();
  cv::Mat_<std::uint8_t> runs(labels.size());
  tbb::parallel_for(0, labels.rows, [&](int v) {
    const int* label = labels[v];
    int run = 0;
    for (int u = labels.cols - 1; u >= 0; --u) {
      run = u + 1 < labels.cols && label[u] == label[u + 1] ? std::min(run + 1, most) : 1;
      runs[v][u] = std::uint8_t(run);
    }
  });
  return runs;
}

/// Sums of points, coordinate by coordinate at once.
class PointSum {
 public:
  /// Of differences to the origin.
  explicit PointSum(const cv::Vec3f& origin) : origin_{origin[0], origin[1], origin[2], 0} {}

  /// Takes points from first up to, but without, end; all is the end of the points that there are.
  void add(const cv::Vec3f* first, const cv::Vec3f* end, const cv::Vec3f* all) {
    const cv::Vec3f* const last = std::min(end, all - 1);
    for (; first < last; ++first) {
      Four p;  // the fourth is of the next point, and of no use
      std::memcpy(&p, first, sizeof(p));
      sum_ += p - origin_;
    }
    if (first < end) sum_ += Four{(*first)[0], (*first)[1], (*first)[2], 0} - origin_;
  }

  Eigen::Vector3f sum() const { return {sum_[0], sum_[1], sum_[2]}; }

 private:
  using Four = float __attribute__((vector_size(4 * sizeof(float))));
  Four origin_, sum_{};
};

float angle(const Eigen::Vector3f& x, const Eigen::Vector3f& y) { return std::acos(std::clamp(x.dot(y), -1.f, 1.f)); }

class BorderCurvatureMeasure final : public Measure {
 public:
  BorderCurvatureMeasure(const Scene& scene, const BorderCurvature::Params& params)
      : frame_(scene.frame()),
        surfaces_(scene.surfaces()),
        radius_(params.support),
        samples_(std::size_t(params.samples)),
        local_(params.normals == "local"),
        runs_(runs_of(surfaces_.labels)) {}

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = values[1] = 0;
    if (!pair.border || pair.border->border_3d.empty()) return;
    const std::vector<PixelPair>& border = pair.border->border_3d;
    const std::size_t step = (border.size() + samples_ - 1) / samples_;
    double sum = 0, squares = 0, count = 0;
    for (std::size_t i = 0; i < border.size(); i += step) {
      const double curvature = at(border[i], pair.border->a, pair.border->b);
      sum += curvature;
      squares += curvature * curvature;
      count += 1;
    }
    values[0] = std::clamp(sum / count, -std::numbers::pi, std::numbers::pi);
    values[1] = std::max(0.0, squares / count - values[0] * values[0]);
  }

 private:
  double at(const PixelPair& touching, int a, int b) const {
    const Support side_a = support(touching.a, a), side_b = support(touching.b, b);
    const Eigen::Vector3f d = side_b.centre - side_a.centre;
    if (!(d.norm() > 0)) return 0;
    const Eigen::Vector3f direction = d.normalized();
    return angle(side_a.normal, direction) + angle(side_b.normal, -direction) - std::numbers::pi;
  }

  /// Mean and normal of a surface within the window around one of its pixels.
  Support support(int pixel, int surface) const {
    const int width = frame_.width(), u0 = pixel % width, v0 = pixel / width;
    const SurfaceModel& model = *surfaces_.surfaces[std::size_t(surface)].model;
    const cv::Vec3f *const points = frame_.points.ptr<cv::Vec3f>(), *const end_of_all = points + frame_.points.total();
    PointSum sums(points[pixel]);
    Eigen::Matrix3f squares = Eigen::Matrix3f::Zero();
    int pixels = 0;
    const Eigen::Vector3f origin = frame_.point(pixel);
    const int left = std::max(0, u0 - radius_), right = std::min(width - 1, u0 + radius_);
    for (int v = std::max(0, v0 - radius_); v <= std::min(frame_.height() - 1, v0 + radius_); ++v) {
      const int* const label = surfaces_.labels[v];
      const std::uint8_t* const run = runs_[v];
      const cv::Vec3f* const row = points + v * width;
      for (int u = left, end; u <= right; u = end) {
        end = std::min(u + run[u], right + 1);
        if (label[u] != surface + 1) continue;
        sums.add(row + u, row + end, end_of_all);
        pixels += end - u;
        if (!local_) continue;
        for (int own = u; own < end; ++own) {
          const Eigen::Vector3f p = frame_.point(v * width + own) - origin;
          squares += p * p.transpose();
        }
      }
    }
    const auto count = float(pixels);
    const Eigen::Vector3f sum = sums.sum();
    const Eigen::Vector3f mean = sum / count;
    const SurfaceModel::Foot foot = model.foot(mean + origin);
    if (!local_ || count < 3) return {foot.point, foot.normal};
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> eigen(squares / count - mean * mean.transpose());
    // A support that is nearly a line has no normal of its own.
    if (eigen.eigenvalues()[1] < 0.02f * eigen.eigenvalues()[2]) return {mean + origin, foot.normal};
    Eigen::Vector3f normal = eigen.eigenvectors().col(0);
    if (normal.dot(mean + origin) > 0) normal = -normal;
    return {mean + origin, normal};
  }

  const Frame& frame_;
  const SurfaceSet& surfaces_;
  const int radius_;
  const std::size_t samples_;
  const bool local_;
  const cv::Mat_<std::uint8_t> runs_;
};

}  // namespace

const Parameters<BorderCurvature::Params>& BorderCurvature::parameters() {
  static const auto parameters =
      Parameters<Params>()
          .integer("support", &Params::support, 0, 100, "px", "reach of the support on either side of the border")
          .choice("normals", &Params::normals, {"fitted", "local"},
                  "normals of the fitted surfaces, or of planes through the support")
          .integer("samples", &Params::samples, 1, 100000, "", "border pairs looked at, evenly spread over the border");
  return parameters;
}

const std::vector<RelationValue>& BorderCurvature::values() const {
  constexpr double pi = std::numbers::pi;
  static const std::vector<RelationValue> values{
      {"r_cu3", -pi, pi,
       "mean curvature over the 3D border, rad; > 0 convex, < 0 concave, 0 flat or without 3D border"},
      {"r_cv3", 0, pi * pi, "variance of that curvature, rad^2; 0 without 3D border"}};
  return values;
}

std::unique_ptr<Measure> BorderCurvature::bind(const Scene& scene) const {
  return std::make_unique<BorderCurvatureMeasure>(scene, params_);
}

}  // namespace gestalt
