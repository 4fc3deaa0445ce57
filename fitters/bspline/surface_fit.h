// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <optional>
#include <span>

#include "gestalt/core/scene/bspline_surface.h"
#include "weighted_points.h"

namespace gestalt {

/// The flat surface over a frame's rectangle, evenly parametrised.
BsplineSurface flat_surface(const PrincipalFrame& frame, int degree, int columns, int rows);

/// The quadratic form of the smoothing term f_s over the control points (Eq. 7): one coordinate's values c have
/// f_s = c' R c / 2. f_s is the integral of |S_xi_xi|^2 + 2 |S_xi_eta|^2 + |S_eta_eta|^2 over the unit square, divided
/// by 1440: for an evenly bent surface, half the mean squared distance to its plane. So it has the unit of e_k / 2, and
/// w_s f_s weighs like w_s points that lie as far off as the surface is bent.
Eigen::MatrixXd smoothness_matrix(const BsplineSurface& surface);

/// Moves the control points to the minimum of f = 1/2 sum_k e_k + w_s f_s (Eq. 6) by turns: closest points of the
/// surface by Newton's method, then linear least squares for them. parameters: first guess of the closest points,
/// one for each point, replaced by better ones. False when the system cannot be solved.
bool fit_surface(BsplineSurface& surface, std::span<const WeightedPoint> points,
                 std::vector<Eigen::Vector2d>& parameters, const Eigen::MatrixXd& smoothness, double weight,
                 int iterations);

/// Inserts a knot into the middle of that span of each direction in which the sum of squared distances is largest,
/// and brings the closest points up to date.
void insert_knots(BsplineSurface& surface, std::span<const WeightedPoint> points,
                  std::vector<Eigen::Vector2d>& parameters);

}  // namespace gestalt
