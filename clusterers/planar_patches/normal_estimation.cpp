// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normal_estimation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

#include "neighbour_moments.h"

namespace gestalt {

namespace {

/// Smallest eigenvalue and a vector of its eigenspace of a symmetric positive semi-definite 3x3 matrix.
struct Smallest {
  float value;
  Eigen::Vector3f vector;  // (0, 0, 0) when the eigenspace is not a line
};

Smallest smallest_eigenpair(const Eigen::Matrix3f& m) {
  // Closed form: trigonometric roots of the characteristic polynomial, then the eigenvector as the longest cross
  // product of two rows of (m - value I).
  const float mean = m.trace() / 3;
  Eigen::Matrix3f shifted = m;
  shifted.diagonal().array() -= mean;
  const float spread = std::sqrt(shifted.squaredNorm() / 6);
  if (!(spread > 0)) return {mean, Eigen::Vector3f::Zero()};
  const float r = std::clamp(shifted.determinant() / (2 * spread * spread * spread), -1.f, 1.f);
  const float value = mean + 2 * spread * std::cos(std::acos(r) / 3 + 2.0943951f);
  shifted = m;
  shifted.diagonal().array() -= value;
  const Eigen::Vector3f a = shifted.row(0), b = shifted.row(1), c = shifted.row(2);
  const Eigen::Vector3f ab = a.cross(b), ac = a.cross(c), bc = b.cross(c);
  const float n_ab = ab.squaredNorm(), n_ac = ac.squaredNorm(), n_bc = bc.squaredNorm();
  const float longest = std::max({n_ab, n_ac, n_bc});
  if (!(longest > 0)) return {value, Eigen::Vector3f::Zero()};
  const Eigen::Vector3f& vector = longest == n_ab ? ab : longest == n_ac ? ac : bc;
  return {value, vector / std::sqrt(longest)};
}

constexpr float edge_on = 1e-4f;  // cosine of ray and normal below which a camera sees no surface, only noise
constexpr int full_window = 8;    // px; of larger radii only every second, third, ... row and column is looked at

class Estimation {
 public:
  Estimation(const Frame& frame, const Tolerances& tolerances)
      : frame_(frame),
        tolerances_(tolerances),
        points_(frame.points),
        map_{cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f()), cv::Mat_<float>(frame.depth.size(), 1.f)} {}

  NormalMap run() {
    tbb::parallel_for(tbb::blocked_range<int>(0, frame_.height(), 8), [&](const tbb::blocked_range<int>& rows) {
      for (int v = rows.begin(); v < rows.end(); ++v)
        for (int u = 0; u < frame_.width(); u += wide_lanes) estimate_lanes(u, v);
    });
    return std::move(map_);
  }

 private:
  /// Of the pixels from (u, v) on that are in the image and have depth. Those of equal windows are summed together.
  void estimate_lanes(int u, int v) {
    std::array<int, wide_lanes> radius{};  // 0: done, or nothing to do
    WideFloats reach{};
    for (int i = 0; i < std::min(wide_lanes, frame_.width() - u); ++i)
      if (const float z = frame_.depth(v, u + i); z > 0) {
        radius[std::size_t(i)] = tolerances_.window_radius(z);
        reach[i] = tolerances_.squared_reach(z);
      }
    for (int i = 0; i < wide_lanes; ++i) {
      const int own = radius[std::size_t(i)];
      if (own == 0) continue;
      if (u < own || u + wide_lanes + own > frame_.width()) {  // a window, or the lanes, leave the image
        NeighbourMoments<float> moments;
        sum_neighbours(points_, u + i, v, window(u + i, v, own), reach[i], moments);
        set_normal(u + i, v, moments);
        continue;
      }
      NeighbourMoments<WideFloats> moments;
      sum_neighbours(points_, u, v, window(u, v, own), reach, moments);
      for (int k = i; k < wide_lanes; ++k)
        if (radius[std::size_t(k)] == own) {
          set_normal(u + k, v, lane(moments, k));
          radius[std::size_t(k)] = 0;
        }
    }
  }

  NeighbourWindow window(int u, int v, int radius) const {
    // Noise is shared by neighbouring pixels: of a large window a sample tells as much.
    const int step = 1 + (radius - 1) / full_window;
    const auto first = [&](int room) { return -(std::min(radius, room) / step * step); };
    return {first(u), std::min(radius, frame_.width() - 1 - u), first(v), std::min(radius, frame_.height() - 1 - v),
            step};
  }

  static NeighbourMoments<float> lane(const NeighbourMoments<WideFloats>& m, int i) {
    return {m.n[i], m.x[i], m.y[i], m.w[i], m.xx[i], m.xy[i], m.xw[i], m.yy[i], m.yw[i], m.ww[i]};
  }

  void set_normal(int u, int v, const NeighbourMoments<float>& m) {
    if (m.n < 3) return;
    const float i = 1 / m.n;
    Eigen::Matrix3f covariance;
    covariance << m.xx - m.x * m.x * i, m.xy - m.x * m.y * i, m.xw - m.x * m.w * i, m.xy - m.x * m.y * i,
        m.yy - m.y * m.y * i, m.yw - m.y * m.w * i, m.xw - m.x * m.w * i, m.yw - m.y * m.w * i, m.ww - m.w * m.w * i;
    const float total = covariance.trace();
    if (!(total > 0)) return;
    // Scaled to a trace of 1: float32 then has room for the cubes of the closed form.
    const Smallest smallest = smallest_eigenpair(covariance / total);
    if (smallest.vector.isZero()) return;
    const Eigen::Vector3f ray = frame_.point(v * frame_.width() + u);
    const float along = smallest.vector.dot(ray);
    if (std::abs(along) < edge_on * ray.norm()) return;
    const float towards = along > 0 ? -1.f : 1.f;
    map_.normals(v, u) = {towards * smallest.vector.x(), towards * smallest.vector.y(), towards * smallest.vector.z()};
    map_.curvature(v, u) = std::clamp(smallest.value, 0.f, 1.f / 3);
  }

  const Frame& frame_;
  const Tolerances& tolerances_;
  const PointPlanes points_;
  NormalMap map_;
};

}  // namespace

NormalMap estimate_normals(const Frame& frame, const Tolerances& tolerances) {
  return Estimation(frame, tolerances).run();
}

}  // namespace gestalt
