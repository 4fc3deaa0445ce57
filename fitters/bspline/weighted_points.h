// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <variant>
#include <vector>

namespace gestalt {

/// The mean of that many points of a patch, metres, camera frame.
struct WeightedPoint {
  Eigen::Vector3d point;
  double weight;
};

/// The rectangle of a patch in the plane of its two largest principal axes: the place of (xi, eta) in the unit square
/// is corner + xi * across + eta * down.
struct PrincipalFrame {
  Eigen::Vector3d corner;
  Eigen::Vector3d across;  ///< along the longest principal axis, as long as the patch
  Eigen::Vector3d down;    ///< along the second
  Eigen::Vector3d normal;  ///< unit, the third, towards the camera

  /// Parameters of the projection of p, not clamped.
  Eigen::Vector2d parameters(const Eigen::Vector3d& p) const {
    const Eigen::Vector3d d = p - corner;
    return {d.dot(across) / across.squaredNorm(), d.dot(down) / down.squaredNorm()};
  }
};

/// The frame of points, or in a few words why they determine none: too few of them (of the sum of the weights),
/// (nearly) collinear, or as thick as they are wide. bounds: the points that the rectangle must hold; means lie further
/// in.
std::variant<PrincipalFrame, const char*> principal_frame(std::span<const WeightedPoint> points,
                                                          std::span<const WeightedPoint> bounds, double fewest);

/// Whether the patch lies in two layers over its principal plane, or stands on it: then it is not a function there.
bool is_folded(std::span<const WeightedPoint> points, const PrincipalFrame& frame);

/// The means of the points in each cell of a grid of cells x cells over the frame, with the points' number as weight;
/// cells without points are left out. With a fixed number of cells, fitting costs the same for any patch.
std::vector<WeightedPoint> cell_means(std::span<const WeightedPoint> points, const PrincipalFrame& frame, int cells);

/// The points that lie farthest out in 16 directions of the frame: bounds for principal_frame().
std::vector<WeightedPoint> extremes(std::span<const WeightedPoint> points, const PrincipalFrame& frame);

}  // namespace gestalt
