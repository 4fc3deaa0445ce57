// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "gestalt/core/scene/bspline_surface.h"

namespace gestalt {

/// A place on a surface and its squared distance to the point that was asked for.
struct ClosestPoint {
  Eigen::Vector2d parameters;  ///< (xi, eta) in the unit square
  double squared_distance;
  bool converged;
};

/// Local minimum of the distance to p within the unit square, by Newton's method from a start in it (paper, Section
/// 4.1). Steps that lead farther away are halved; where the Hessian is not positive definite, Gauss and Newton's is
/// taken. Never farther from p than the start is.
ClosestPoint newton(const BsplineSurface& surface, const Eigen::Vector3d& p, const Eigen::Vector2d& start);

/// Closest point by newton(); where that does not converge, once more from the nearest of a grid of places.
ClosestPoint closest_point(const BsplineSurface& surface, const Eigen::Vector3d& p, const Eigen::Vector2d& start);

}  // namespace gestalt
