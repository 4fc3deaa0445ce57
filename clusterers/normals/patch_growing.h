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
  int min_patch_size = 9;       ///< px
  int spur_neighbours = 3;      ///< px
  double spur_distance = 0.01;  ///< m
};

/// Recursive clustering (paper, Section 3). Seeds in order of increasing curvature; a patch grows over 4-neighbours
/// whose normal is within eps(z) of the patch's mean normal and which lie within omega(z) of the patch's running plane.
/// What is left over is clustered by connectivity, and thin spurs join the patch beside them. Gives labels 1..n in
/// order of growth, all in use; 0 where there is no depth. n is written to count.
cv::Mat_<int> grow_patches(const Frame& frame, const NormalMap& normals, const GrowingParams& params, int& count);

}  // namespace gestalt
