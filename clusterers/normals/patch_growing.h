// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/frame.h"
#include "normal_estimation.h"

namespace gestalt {

/// Defaults are those of the authors' published program.
struct GrowingParams {
  double angle = 0.58;  ///< eps(z) = angle + angle_per_metre * z, rad
  double angle_per_metre = 0.1;
  double distance = -0.002;  ///< omega(z) = distance + distance_per_metre * z, m
  double distance_per_metre = 0.015;
  int min_patch_size = 9;         ///< px
  int spur_radius = 2;            ///< px; 0 leaves spurs where they are
  double spur_distance = 0.01;    ///< m
  int smallest_island = 30;       ///< px
  double island_distance = 0.05;  ///< m
};

/// Recursive clustering (paper, Section 3). Seeds in order of increasing curvature; a patch grows over 4-neighbours
/// whose normal is within eps(z) of the patch's mean normal and which lie within omega(z) of the patch's running plane.
/// Then spurs, strips too thin for a square of 2 * spur_radius + 1 pixels, are cut from their patches and, like the
/// pixels without a normal, go to the touching patch whose plane is nearest. What no patch takes is clustered by
/// connectivity. Gives labels 1..count in order of growth, all in use; 0 where there is no depth, and for specks.
cv::Mat_<int> grow_patches(const Frame& frame, const NormalMap& normals, const GrowingParams& params, int& count);

}  // namespace gestalt
