// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "minimum_distance.h"

GESTALT_PLUGIN(gestalt::component<gestalt::MinimumDistance>(
    "minimum_distance", "1.0.0", "r_md: minimum distance between the contours of two patches"))
