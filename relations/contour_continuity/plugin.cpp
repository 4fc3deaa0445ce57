// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "contour_continuity.h"

GESTALT_PLUGIN(gestalt::component<gestalt::ContourContinuity>(
    "contour_continuity", "1.0.0", "r_ac, r_dn: continuation of the surfaces where the contours are nearest"))
