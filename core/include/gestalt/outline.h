// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gestalt/contour.h"
#include "gestalt/frame.h"

namespace gestalt {

/// Where a surface ends: points spread evenly over all its contours, those of holes too, moved onto the fitted surface,
/// as depth is worst at contours. Column i of points and normals belongs to pixels[i].
struct Outline {
  static constexpr int largest = 256;  ///< points of one surface

  std::vector<int> pixels;   ///< row-major indices, not empty
  Eigen::Matrix3Xf points;   ///< metres, camera frame
  Eigen::Matrix3Xf normals;  ///< unit, towards the camera
};

/// Outlines of all surfaces. Every contour pixel is taken when there are at most Outline::largest, else every n-th, so
/// that no contour pixel is further than n / 2 steps along its contour from one that is taken.
GESTALT_EXPORT std::vector<Outline> find_outlines(const Frame& frame, const SurfaceSet& surfaces,
                                                  const std::vector<std::vector<Contour>>& contours);

}  // namespace gestalt
