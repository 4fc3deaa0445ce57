// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "oriented_box.h"

namespace gestalt {

/// A surface of an object.
struct Facet {
  int patch = 0;
  Points points;           ///< metres
  Eigen::Vector3d normal;  ///< unit, mean, towards the camera
  double rms = 0;          ///< metres, of the points from their plane
};

/// The shape that the object's surfaces lie on. tolerance: metres, the error of depth that a shape may leave as root
/// mean square. Of the shapes that fit, a plane is taken first, if the object is not thicker than a few tolerances over
/// its support; then the one with the least error. Fewer than 50 points are of no kind.
GESTALT_EXPORT ShapeKind find_kind(const std::vector<Facet>& facets, const OrientedBox& box,
                                   const std::optional<Support>& support, double tolerance);

}  // namespace gestalt
