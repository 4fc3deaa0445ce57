// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "cases.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"

namespace gestalt::properties {

/// A frame of at most 28x22 pixels, at least one with depth: slanted, bent and edge-on planes, steps, noise, holes, and
/// depths that no sensor gives, before make_frame() judges them; any camera that it takes; colours constant, striped or
/// random.
Frame hostile_frame(Chance& chance);

/// Patches that no clusterer would make: single pixels, rows, columns, a checkerboard, blocks, random labels, one patch
/// of all; normals arbitrary, some missing.
PatchMap hostile_patches(Chance& chance, const Frame& frame);

}  // namespace gestalt::properties
