// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normal_estimation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <vector>

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

}  // namespace

NormalMap estimate_normals(const Frame& frame, const Tolerances& tolerances) {
  NormalMap map{cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f()), cv::Mat_<float>(frame.depth.size(), 1.f)};
  const int width = frame.width(), height = frame.height();

  tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
    for (int v = rows.begin(); v < rows.end(); ++v)
      for (int u = 0; u < width; ++u) {
        const float z = frame.depth(v, u);
        if (!(z > 0)) continue;
        const cv::Vec3f& p = frame.points(v, u);
        const int radius = tolerances.window_radius(z);
        // Noise is shared by neighbouring pixels: of a large window a sample tells as much.
        const int step = 1 + (radius - 1) / full_window;
        const float reach = tolerances.squared_reach(z);
        float n = 0, x = 0, y = 0, w = 0, xx = 0, xy = 0, xw = 0, yy = 0, yw = 0, ww = 0;
        const int first_du = -(std::min(radius, u) / step * step), last_du = std::min(radius, width - 1 - u);
        for (int dv = -(std::min(radius, v) / step * step); dv <= std::min(radius, height - 1 - v); dv += step) {
          const cv::Vec3f* row = frame.points[v + dv] + u;
          for (int du = first_du; du <= last_du; du += step) {
            const float dx = row[du][0] - p[0], dy = row[du][1] - p[1], dz = row[du][2] - p[2];
            // A pixel without depth is the origin: at least z away, and so out of reach.
            const float counts = dx * dx + dy * dy + dz * dz <= reach * float(du * du + dv * dv) ? 1.f : 0.f;
            n += counts;
            x += counts * dx, y += counts * dy, w += counts * dz;
            xx += counts * dx * dx, xy += counts * dx * dy, xw += counts * dx * dz;
            yy += counts * dy * dy, yw += counts * dy * dz, ww += counts * dz * dz;
          }
        }
        if (n < 3) continue;
        const float i = 1 / n;
        Eigen::Matrix3f covariance;
        covariance << xx - x * x * i, xy - x * y * i, xw - x * w * i, xy - x * y * i, yy - y * y * i, yw - y * w * i,
            xw - x * w * i, yw - y * w * i, ww - w * w * i;
        const float total = covariance.trace();
        if (!(total > 0)) continue;
        // Scaled to a trace of 1: float32 then has room for the cubes of the closed form.
        const Smallest smallest = smallest_eigenpair(covariance / total);
        if (smallest.vector.isZero()) continue;
        const Eigen::Vector3f ray(p[0], p[1], p[2]);
        const float along = smallest.vector.dot(ray);
        if (std::abs(along) < edge_on * ray.norm()) continue;
        const float towards = along > 0 ? -1.f : 1.f;
        map.normals(v, u) = {towards * smallest.vector.x(), towards * smallest.vector.y(),
                             towards * smallest.vector.z()};
        map.curvature(v, u) = std::clamp(smallest.value, 0.f, 1.f / 3);
      }
  });
  return map;
}

}  // namespace gestalt
