// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"
#include "normal_estimation.h"
#include "patch_growing.h"
#include "tolerances.h"

namespace gestalt {

/// Weights of Eq. 3; S_m is 1 for a plane.
struct SelectionParams {
  double kappa_1 = 0.001;  ///< of a patch, as a share of the coarse patch's points
  double kappa_2 = 1;      ///< of the error
  double error_noise = 2;  ///< p(f_i | H) = exp(-e_i^2 / (error_noise sigma(z))^2)
};

/// The patches of one resolution with the frame that they are of.
struct PyramidLevel {
  Frame frame;
  NormalMap normals;
  Tolerances tolerances;
  LabelledPatches patches;
};

/// Model selection between two levels (paper, Section 3, Eq. 1-4): for each patch of the coarse level, it or the
/// patches of the fine level that overlap it, whichever saves more. Both sides count the fine level's points under the
/// coarse patch, and both divide by their number, A_m. Of the fine patches those count that save something. Where the
/// coarse level has no patch the fine level's stay. Gives labels of the fine level's size; not all need be in use.
/// Pixels at the outline of a kept coarse patch, which is known to two pixels only, go to the patch whose plane is
/// nearest.
LabelledPatches select_patches(const PyramidLevel& coarse, const PyramidLevel& fine, const SelectionParams& params);

}  // namespace gestalt
