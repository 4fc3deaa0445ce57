// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "oriented_box.h"

namespace gestalt {

/// A surface of the background as a plane.
struct BackgroundPlane {
  int patch;
  Eigen::Vector3d normal;  ///< unit, towards the camera
  double offset;           ///< normal . p of its points, metres
  double share;            ///< of the frame's pixels
};

/// Surfaces of the background that are flat to a hundredth of their size and of a thousandth of the frame at least.
std::vector<BackgroundPlane> background_planes(const Percept& percept);

/// The plane that the object is on: of those that its patches touch in the image, and that have it in front, the one
/// that it is nearest to; where there is none, the largest that has it in front. surfaces: of the object.
std::optional<Support> find_support(const std::vector<BackgroundPlane>& planes, const Percept& percept,
                                    const std::vector<int>& surfaces, const Points& points);

}  // namespace gestalt
