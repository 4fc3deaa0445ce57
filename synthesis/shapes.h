// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <functional>
#include <numbers>
#include <vector>

#include "mesh.h"

namespace gestalt::synthesis {

inline constexpr double turn = 2 * std::numbers::pi;  ///< a full one, rad

// Solids in their own frame, metres: z up, standing on z = 0, centred on the z axis. The part numbers that each
// documents choose the texture.

/// Six faces: parts 0 front (-y), 1 back, 2 left (-x), 3 right, 4 top, 5 bottom; texture v runs downwards.
Mesh box(const Eigen::Vector3d& size);

/// A curve (radius, z) over t in [0, 1] that turns about the z axis.
using Profile = std::function<Eigen::Vector2d(double t)>;

Profile line(const Eigen::Vector2d& from, const Eigen::Vector2d& to);

/// A surface of revolution; piece i is part i. Creases are where pieces meet.
Mesh revolution(const std::vector<Profile>& pieces);

/// Parts 0 side, 1 top, 2 bottom.
Mesh cylinder(double radius, double height);

/// Hollow: parts 0 outside, 1 inside, 2 rim, 3 foot.
Mesh bowl(double radius, double foot_radius, double height, double wall);

/// Hollow cylinder with a handle of torus shape towards +x: parts 0 outside, 1 inside, 2 rim, 3 inner bottom, 4 foot,
/// 5 handle.
Mesh mug(double radius, double height, double wall, double handle_radius);

/// Round body, shoulder, neck and cap: parts 0 body, 1 shoulder, 2 neck, 3 cap, 4 top, 5 bottom.
Mesh bottle(double radius, double height, double neck_radius);

/// Truncated cone, a point for top_radius 0: parts 0 side, 1 top, 2 bottom.
Mesh cone(double bottom_radius, double top_radius, double height);

/// |x/a|^(2/e2) ... with roundness e1 (along z) and e2 (around) in (0, 2]: 0.2 nearly a box, 1 an ellipsoid. Part 0.
Mesh superellipsoid(const Eigen::Vector3d& half_axes, double e1, double e2);

/// A prism over an outline that is star-shaped about the origin: parts 0 sides, 1 top, 2 bottom.
Mesh extrusion(const std::vector<Eigen::Vector2d>& outline, double height);

/// A bag that lies: flat seams all round, a bulging top. size.z is its thickness. Parts 0 top, 1 bottom.
Mesh pillow(const Eigen::Vector3d& size);

/// A bag that stands: a flat bottom size.x wide and size.y deep, closed to a line at the top. Parts 0 front, 1 back,
/// 2 bottom.
Mesh pouch(const Eigen::Vector3d& size);

/// Adds another solid, moved; its parts are numbered on from `first_part`.
void join(Mesh& mesh, const Mesh& other, const Eigen::Isometry3d& pose, int first_part);

}  // namespace gestalt::synthesis
