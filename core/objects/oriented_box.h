// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gestalt/core/objects/object_description.h"

namespace gestalt {

using Points = std::vector<Eigen::Vector3d>;

/// Two unit vectors that make a right-handed frame with up, which is one, as third.
GESTALT_EXPORT std::pair<Eigen::Vector3d, Eigen::Vector3d> across(const Eigen::Vector3d& up);

/// The box around points that stands along up. normals: of the object's surfaces, the largest first: a side seen from
/// the front says more about the direction than the outline does, as all rectangles along the sides of a triangle have
/// one area. Of no points: the default.
GESTALT_EXPORT OrientedBox box_around(const Points& points, const Eigen::Vector3d& up, const Points& normals);

}  // namespace gestalt
