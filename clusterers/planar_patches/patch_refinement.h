// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include "patch_growing.h"

namespace gestalt {

/// Clears up the outlines of patches. Spurs, strips too thin for a square of 2 * spur_radius + 1 pixels, are cut from
/// their patches and, like the pixels that are in no patch, go to the touching patch whose plane is nearest, where one
/// is within omega(z). Labels stay as they are; a patch may vanish.
LabelledPatches tidy_outlines(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances,
                              LabelledPatches patches);

/// Clusters what is in no patch by connectivity; of that islands join the patch around them, or none. Gives labels in
/// the order of the patches, all in use; 0 where there is no depth, and for specks.
LabelledPatches gather_leftovers(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances,
                                 LabelledPatches patches);

}  // namespace gestalt
