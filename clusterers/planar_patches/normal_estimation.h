// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"
#include "tolerances.h"

namespace gestalt {

/// Every pixel's normal.
struct NormalMap {
  cv::Mat_<cv::Vec3f>
      normals;  ///< unit, towards the camera; (0, 0, 0) without depth, with fewer than 3 neighbours, or seen edge-on
  cv::Mat_<float>
      curvature;  ///< smallest eigenvalue over the sum of all three, in [0, 1/3]; 1 where there is no normal
};

/// Least-squares normals over a window that grows with the noise of the depth; neighbours are the pixels of the window
/// within Tolerances::squared_reach(), which keeps the far side of a depth jump out.
NormalMap estimate_normals(const Frame& frame, const Tolerances& tolerances);

}  // namespace gestalt
