// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "body.h"
#include "random.h"

namespace gestalt::synthesis {

// What holds things and is background. Their inner floor is z = 0, centred on the origin, before `pose`.

inline constexpr double container_floor = 0.004;  ///< metres: thickness

/// A tote or an open cardboard box, some with flaps. inner: width, depth and height of its inside, metres.
std::vector<Body> bin(const Eigen::Vector3d& inner, const Eigen::Isometry3d& pose, Random& random);

/// Back, sides and, where `above` > 0, a second board at this height (metres) over a board of this size at z = 0.
std::vector<Body> shelf(const Eigen::Vector2d& size, double above, Random& random);

}  // namespace gestalt::synthesis
