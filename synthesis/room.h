// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "body.h"
#include "random.h"

namespace gestalt::synthesis {

/// What things stand on and all that is around: measured, and background.
struct Room {
  Body table;                   ///< its top at z = 0
  Eigen::AlignedBox2d top;      ///< in the table's own frame, about the world's origin
  double yaw;                   ///< rad, of the table
  std::vector<Body> furniture;  ///< legs, floor, walls, boxes as large as cupboards
};

/// A table with legs, a counter or the bare floor, in a room of 3 to 8 m.
Room random_room(Random& random);

/// The same around a board on which things stand, 0.7 to 1.5 m above the floor, its back against a wall.
Room room_around_board(const Eigen::Vector2d& size, Random& random);

/// A box with its lower left front corner at `low`, world, in one texture.
Body block(const Eigen::Vector3d& low, const Eigen::Vector3d& size, const Texture& texture);

}  // namespace gestalt::synthesis
