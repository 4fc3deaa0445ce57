// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <optional>
#include <vector>

#include "body.h"
#include "gestalt/synthesis/synthesis.h"
#include "random.h"
#include "viewpoint.h"

namespace gestalt::synthesis {

struct Lighting {
  Eigen::Vector3d lamp;      ///< centre of a round ceiling lamp, world, metres
  double lamp_radius = 0.2;  ///< metres; makes shadows soft
  Eigen::Vector3d window;    ///< unit direction towards a second light without shadows
  double lamp_strength, window_strength, ambient;
  cv::Vec3f tint{1, 1, 1};  ///< blue, green, red gain
};

/// Everything that is seen. World frame: metres, z up, the table top at z = 0, the origin where the things are.
struct Arrangement {
  Viewpoint viewpoint;
  Lighting lighting;
  Body table;
  std::vector<Body> surroundings;  ///< floor and wall: seen, but beyond what is measured
  std::vector<Body> things;
};

/// One layout of a category, or nothing when the things could not be placed so that each is seen well enough.
std::optional<Arrangement> lay_out(Category category, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
