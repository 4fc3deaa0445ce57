// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "common_surface.h"

GESTALT_PLUGIN(gestalt::component<gestalt::CommonSurface>(
    "common_surface", "1.0.0", "r_sp: distance of the contour of one patch to the surface of the other"))
