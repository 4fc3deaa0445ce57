// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "body.h"
#include "gestalt/synthesis/synthesis.h"
#include "lighting.h"
#include "random.h"
#include "viewpoint.h"

namespace gestalt::synthesis {

/// Everything that is seen. World frame: metres, z up, the table top at z = 0, the origin where the things are.
struct Arrangement {
  Viewpoint viewpoint;
  Lighting lighting;
  Body table;
  std::vector<Body> surroundings;  ///< floor and wall: seen, but beyond what is measured
  std::vector<Body> furniture;     ///< measured background: bin, shelf, legs of the table, room
  std::vector<Body> things;
};

/// One layout of a category, or nothing when the things could not be placed so that each is seen well enough.
std::optional<Arrangement> lay_out(Category category, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
