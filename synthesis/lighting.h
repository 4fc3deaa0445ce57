// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include "random.h"

namespace gestalt::synthesis {

struct Lighting {
  Eigen::Vector3d lamp;      ///< centre of a round ceiling lamp, world, metres
  double lamp_radius = 0.2;  ///< metres; makes shadows soft
  Eigen::Vector3d window;    ///< unit direction towards a second light without shadows
  double lamp_strength, window_strength, ambient;
  cv::Vec3f tint{1, 1, 1};  ///< blue, green, red gain
};

Lighting random_lighting(Random& random);

}  // namespace gestalt::synthesis
