// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"
#include "normal_estimation.h"
#include "tolerances.h"

namespace gestalt {

struct LabelledPatches {
  cv::Mat_<int> labels;  ///< 0 = in no patch, else 1..count
  int count = 0;
};

/// Recursive clustering (paper, Section 3). Seeds in order of increasing curvature; a patch grows over 4-neighbours
/// whose normal is within eps(z) of the patch's mean normal and which lie within omega(z) of the patch's running plane.
/// That plane is updated whenever the patch has grown by a 1024th. Labels are in order of growth and all in use;
/// patches below min_patch_size are dissolved.
LabelledPatches grow_patches(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances);

}  // namespace gestalt
