// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "closure.h"

GESTALT_PLUGIN(gestalt::component<gestalt::ClosureRelation>(
    "closure", "1.0.0",
    "r_ls, r_as, r_lg: line support, area support and gaps of closed contours through both patches"))
