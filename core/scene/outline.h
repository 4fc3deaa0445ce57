// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gestalt/core/scene/contour.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// Where a surface ends: points spread evenly over all its contours, those of holes too, moved onto the fitted surface,
/// as depth is worst at contours. Column i of points and normals belongs to pixels[i].
struct Outline {
  static constexpr int largest = 128;  ///< points of one surface

  std::vector<int> pixels;   ///< row-major indices, not empty
  Eigen::Matrix3Xf points;   ///< metres, camera frame
  Eigen::Matrix3Xf normals;  ///< unit, towards the camera
};

/// Outlines of all surfaces. Every contour pixel is taken when there are at most Outline::largest, else every n-th, so
/// that no contour pixel is further than n / 2 steps along its contour from one that is taken.
GESTALT_EXPORT std::vector<Outline> find_outlines(const Frame& frame, const SurfaceSet& surfaces,
                                                  const std::vector<std::vector<Contour>>& contours);

/// Squared distances of all columns of a matrix to points. The coordinates are kept apart, so that several columns are
/// computed at once.
class SquaredDistances {
 public:
  explicit SquaredDistances(const Eigen::Matrix3Xf& to) : x_(to.row(0)), y_(to.row(1)), z_(to.row(2)) {}

  /// squared has as many entries as there are columns.
  void operator()(const Eigen::Vector3f& p, Eigen::ArrayXf& squared) const {
    squared = (x_ - p.x()).square() + (y_ - p.y()).square() + (z_ - p.z()).square();
  }

 private:
  Eigen::ArrayXf x_, y_, z_;
};

/// A point of one outline and the point of another that is nearest to it, as column indices.
struct NearestPoint {
  float squared_distance;
  int from;
  int to;
};

/// For every column of from the nearest column of to (the first of several), and of these pairs the share that is
/// nearest, at least one (the first of equals), in no particular order. Neither is empty; share in (0, 1].
GESTALT_EXPORT std::vector<NearestPoint> nearest_points(const Eigen::Matrix3Xf& from, const Eigen::Matrix3Xf& to,
                                                        double share);

/// At most count columns of an outline, evenly spread: their indices.
GESTALT_EXPORT std::vector<int> spread_columns(const Outline& outline, int count);

}  // namespace gestalt
