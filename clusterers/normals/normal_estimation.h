// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/frame.h"

namespace gestalt {

/// Defaults are those of the authors' published program.
struct NormalParams {
  int window_radius = 3;            ///< px, below window_growth_start
  double window_growth_start = 2;   ///< m
  double window_growth_step = 0.5;  ///< m of depth for each further pixel of radius
  double neighbour_slope = 0.005125;
};

struct NormalMap {
  cv::Mat_<cv::Vec3f> normals;  ///< unit, towards the camera; (0, 0, 0) without depth or with fewer than 3 neighbours
  cv::Mat_<float>
      curvature;  ///< smallest eigenvalue over the sum of all three, in [0, 1/3]; 1 where there is no normal
};

/// Least-squares normals over a window that grows with depth; a neighbour at image distance r px counts when its 3D
/// distance is below neighbour_slope * r * z, which keeps the far side of a depth jump out.
NormalMap estimate_normals(const Frame& frame, const NormalParams& params);

}  // namespace gestalt
