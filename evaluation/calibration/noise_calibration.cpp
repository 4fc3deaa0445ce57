// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/calibration/noise_calibration.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

constexpr double window_angle = 0.064;      // rad, 33 px of a Kinect: errors are alike over ten pixels and more
constexpr double bin_ratio = 1.15;          // far end of a bin over its near end
constexpr double reading_unit = 1e-4;       // m
constexpr std::size_t fewest_windows = 20;  // of a bin
constexpr double least_share_valid = 0.8;   // of a window's pixels

int bin_of(double depth) { return int(std::floor(std::log(depth) / std::log(bin_ratio))); }

float middle(std::vector<float> values, double quantile) {
  const auto at = values.begin() + std::ptrdiff_t(quantile * double(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

/// Variance of the readings of a square of pixels about the plane that fits them best; nothing when too few are valid.
std::optional<std::pair<double, double>> depth_and_variance(const Frame& frame, int u0, int v0, int side,
                                                            int& samples) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  double squares = 0, depth = 0;
  samples = 0;
  for (int v = 0; v < side; ++v)
    for (int u = 0; u < side; ++u) {
      const double z = double(frame.depth(v0 + v, u0 + u));
      if (!(z > 0)) continue;
      const Eigen::Vector3d row(u - 0.5 * (side - 1), v - 0.5 * (side - 1), 1);
      normal += row * row.transpose();
      right += row / z;
      squares += 1 / (z * z);
      depth += z;
      ++samples;
    }
  if (samples < least_share_valid * side * side) return std::nullopt;
  depth /= samples;
  // A small error of 1/z is one of z, z^2 times as large.
  const double residual = squares - right.dot(normal.ldlt().solve(right));
  return std::pair(depth, std::max(0.0, residual) / (samples - 3) * std::pow(depth, 4));
}

/// Distance of neighbouring readings in metres, the median over those that occur.
double step_between(const std::set<int>& readings) {
  std::vector<float> gaps;
  for (auto reading = readings.begin(); std::next(reading) != readings.end(); ++reading)
    gaps.push_back(float(*std::next(reading) - *reading));
  return reading_unit * double(middle(std::move(gaps), 0.5));
}

/// The coefficients, none negative, with the least squared relative error over the bins: the best of those fits in
/// which some are left out and the others come out positive.
DepthNoise fit(const std::vector<NoiseBin>& bins) {
  DepthNoise best{0, 0, 0};
  double least = std::numeric_limits<double>::infinity();
  for (int chosen = 1; chosen < 8; ++chosen) {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(Eigen::Index(bins.size()), 3);
    Eigen::VectorXd ones(Eigen::Index(bins.size()));
    for (Eigen::Index i = 0; i < rows.rows(); ++i) {
      const NoiseBin& bin = bins[std::size_t(i)];
      const double weight = std::sqrt(double(bin.windows));
      for (int power = 0; power < 3; ++power)
        if (chosen >> power & 1) rows(i, power) = weight * std::pow(bin.depth, power) / bin.sigma;
      ones[i] = weight;
    }
    const Eigen::Vector3d c = rows.completeOrthogonalDecomposition().solve(ones);
    const double error = (rows * c - ones).squaredNorm();
    if (c.minCoeff() < 0 || error >= least * (1 - 1e-9)) continue;
    least = error;
    best = {c[0], c[1], c[2]};
  }
  return best;
}

}  // namespace

void NoiseCalibration::add(const Frame& frame) {
  const double focal_length = std::sqrt(frame.camera.fx * frame.camera.fy);
  const int side = std::max(5, int(std::lround(window_angle * focal_length)));
  for (int v = 0; v + side <= frame.height(); v += side / 2)
    for (int u = 0; u + side <= frame.width(); u += side / 2) {
      int samples = 0;
      if (const auto found = depth_and_variance(frame, u, v, side, samples))
        bins_[bin_of(found->first)].windows.push_back({float(found->first), float(found->second), samples});
    }
  for (const float z : frame.depth)
    if (z > 0) bins_[bin_of(z)].readings.insert(int(std::lround(double(z) / reading_unit)));
}

std::vector<NoiseBin> NoiseCalibration::bins(const DepthNoise* known) const {
  std::vector<NoiseBin> found;
  for (const auto& [number, bin] : bins_) {
    if (bin.windows.size() < fewest_windows || bin.readings.size() < 2) continue;
    std::vector<float> variances;
    double depth = 0;
    for (const Window& window : bin.windows) {
      variances.push_back(window.variance);
      depth += double(window.depth) / double(bin.windows.size());
    }
    const double step = step_between(bin.readings), least = std::max(step * step / 12, 1e-12);
    double usual = std::max(double(middle(variances, 0.25)), least);
    if (known) usual = std::min(usual, known->at(depth) * known->at(depth));
    NoiseBin planar{0, 0, 0, 0, step};
    variances.clear();
    for (const Window& window : bin.windows) {
      if (double(window.variance) > 4 * usual) continue;
      variances.push_back(window.variance);
      planar.depth += double(window.depth);
      planar.samples += std::size_t(window.samples);
      ++planar.windows;
    }
    if (std::size_t(planar.windows) < fewest_windows) continue;
    planar.depth /= planar.windows;
    planar.sigma = std::sqrt(std::max(double(middle(variances, 0.5)), least));
    found.push_back(planar);
  }
  return found;
}

NoiseEstimate NoiseCalibration::estimate() const {
  NoiseEstimate estimate{{}, bins(nullptr)};
  if (estimate.bins.empty())
    throw InputError("no range of depths has " + std::to_string(fewest_windows) + " windows of " +
                     std::to_string(int(least_share_valid * 100)) +
                     " % measured pixels; give more scenes, or scenes with larger surfaces");
  estimate.noise = fit(estimate.bins);
  // A bin may hold clutter only: what the other bins say of its noise tells.
  for (int round = 0; round < 5; ++round) {
    std::vector<NoiseBin> kept = bins(&estimate.noise);
    if (kept.empty()) break;
    estimate.bins = std::move(kept);
    estimate.noise = fit(estimate.bins);
  }
  return estimate;
}

}  // namespace gestalt
