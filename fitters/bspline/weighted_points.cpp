// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "weighted_points.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "gestalt/core/scene/moments.h"

namespace gestalt {

namespace {

/// Cell of a parameter in [0, 1] among that many.
int cell_of(double parameter, int cells) { return std::clamp(int(parameter * cells), 0, cells - 1); }

}  // namespace

std::variant<PrincipalFrame, const char*> principal_frame(std::span<const WeightedPoint> points,
                                                          std::span<const WeightedPoint> bounds, double fewest) {
  if (points.empty()) return "too few points";
  const Eigen::Vector3d origin = points.front().point;
  Moments moments;
  for (const WeightedPoint& p : points) moments.add(p.point - origin, p.weight);
  if (moments.weight < fewest) return "too few points";

  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(moments.covariance());
  const Eigen::Vector3d variance = eigen.eigenvalues();
  constexpr double narrowest = 1e-4;  // width over length, squared: 1 to 100
  constexpr double thickest = 0.5;    // thickness over width, squared: a half sphere has 0.22
  // Rounding of single-precision input leaves a variance of about 1e-14 of the squared distance.
  const double nothing = 1e-12 * (1 + origin.squaredNorm());
  if (!(variance[1] > std::max(narrowest * variance[2], nothing))) return "collinear points";
  if (variance[0] > thickest * variance[1]) return "points as thick as they are wide";

  PrincipalFrame frame;
  const Eigen::Vector3d centre = origin + moments.mean(), axis_xi = eigen.eigenvectors().col(2),
                        axis_eta = eigen.eigenvectors().col(1);
  frame.normal = eigen.eigenvectors().col(0);
  if (frame.normal.dot(centre) > 0) frame.normal = -frame.normal;
  Eigen::Vector2d low = Eigen::Vector2d::Zero(), high = low;
  for (const WeightedPoint& p : bounds) {
    const Eigen::Vector3d d = p.point - centre;
    const Eigen::Vector2d place(d.dot(axis_xi), d.dot(axis_eta));
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  frame.corner = centre + low.x() * axis_xi + low.y() * axis_eta;
  frame.across = (high.x() - low.x()) * axis_xi;
  frame.down = (high.y() - low.y()) * axis_eta;
  return frame;
}

bool is_folded(std::span<const WeightedPoint> points, const PrincipalFrame& frame) {
  // A single sheet is nearly flat within a small block, however steep it is; two layers, or one that turns back, are
  // as thick as the block is wide.
  constexpr int blocks = 4;
  constexpr double thickest = 0.25;  // standard deviation of the thickness over the block's width
  constexpr double largest_share = 0.1;
  std::array<Moments, blocks * blocks> moments;
  for (const WeightedPoint& p : points) {
    const Eigen::Vector2d at = frame.parameters(p.point);
    moments[std::size_t(cell_of(at.y(), blocks) * blocks + cell_of(at.x(), blocks))].add(p.point - frame.corner,
                                                                                         p.weight);
  }
  const double width = std::min(frame.across.norm(), frame.down.norm()) / blocks;
  double folded = 0, all = 0;
  for (const Moments& block : moments) {
    if (block.weight == 0) continue;
    all += block.weight;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(block.covariance(), Eigen::EigenvaluesOnly);
    if (eigen.eigenvalues()[0] > std::pow(thickest * width, 2)) folded += block.weight;
  }
  return folded > largest_share * all;
}

std::vector<WeightedPoint> cell_means(std::span<const WeightedPoint> points, const PrincipalFrame& frame, int cells) {
  std::vector<WeightedPoint> sums(std::size_t(cells * cells), {Eigen::Vector3d::Zero(), 0});
  for (const WeightedPoint& p : points) {
    const Eigen::Vector2d at = frame.parameters(p.point);
    WeightedPoint& cell = sums[std::size_t(cell_of(at.y(), cells) * cells + cell_of(at.x(), cells))];
    cell.point += p.weight * p.point;
    cell.weight += p.weight;
  }
  std::vector<WeightedPoint> means;
  for (const WeightedPoint& sum : sums)
    if (sum.weight > 0) means.push_back({sum.point / sum.weight, sum.weight});
  return means;
}

std::vector<WeightedPoint> extremes(std::span<const WeightedPoint> points, const PrincipalFrame& frame) {
  std::vector<WeightedPoint> result;
  if (points.empty()) return result;
  constexpr int axes = 8;
  for (int i = 0; i < axes; ++i) {
    const double angle = std::numbers::pi * i / axes;
    const Eigen::Vector3d axis =
        std::cos(angle) * frame.across.normalized() + std::sin(angle) * frame.down.normalized();
    const auto [low, high] = std::minmax_element(points.begin(), points.end(), [&](const auto& a, const auto& b) {
      return a.point.dot(axis) < b.point.dot(axis);
    });
    result.push_back({low->point, 0});
    result.push_back({high->point, 0});
  }
  return result;
}

}  // namespace gestalt
