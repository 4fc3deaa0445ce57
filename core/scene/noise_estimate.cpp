// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/noise_estimate.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <vector>

namespace gestalt {

namespace {

constexpr double window_angle = 0.064;  // rad: errors of depth are alike over ten pixels and more
constexpr double quantile = 0.1;
constexpr int samples_of_a_side = 16;  // of a window, at most
constexpr std::size_t fewest_windows = 40;
constexpr double least_share_valid = 0.8;  // of a window's samples

/// Standard deviation of a window's depth about a plane, whose inverse depth is linear in the pixel (1/z = a u + b v +
/// c), in units of the noise at its mean depth; nothing when too little is measured.
std::optional<double> deviation(const Frame& frame, int u0, int v0, int side, const DepthNoise& noise) {
  const int step = (side + samples_of_a_side - 1) / samples_of_a_side;
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0, depth = 0;
  int samples = 0, all = 0;
  for (int v = 0; v < side; v += step) {
    const float* const row = frame.depth[v0 + v] + u0;
    for (int u = 0; u < side; u += step) {
      ++all;
      if (!(row[u] > 0)) continue;
      const double inverse = 1 / double(row[u]);
      const Eigen::Vector3d terms(u - side / 2, v - side / 2, 1);
      normal += terms * terms.transpose();
      right += terms * inverse;
      squares += inverse * inverse;
      depth += double(row[u]);
      ++samples;
    }
  }
  if (samples < least_share_valid * all) return std::nullopt;
  depth /= samples;
  // A small error of 1/z is one of z, z^2 times as large.
  const double residual = std::max(0.0, squares - right.dot(normal.ldlt().solve(right)));
  return std::sqrt(residual / (samples - 3)) * depth * depth / noise.at(depth);
}

}  // namespace

std::optional<double> estimate_noise(const Frame& frame, const DepthNoise& noise) {
  const int side = std::max(5, int(std::lround(window_angle * std::sqrt(frame.camera.fx * frame.camera.fy))));
  std::vector<double> deviations;
  for (int v = 0; v + side <= frame.height(); v += side)
    for (int u = 0; u + side <= frame.width(); u += side)
      if (const auto found = deviation(frame, u, v, side, noise)) deviations.push_back(*found);
  if (deviations.size() < fewest_windows) return std::nullopt;
  const auto at = deviations.begin() + std::ptrdiff_t(quantile * double(deviations.size() - 1));
  std::nth_element(deviations.begin(), at, deviations.end());
  return *at;
}

}  // namespace gestalt
