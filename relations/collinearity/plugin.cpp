// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "collinearity.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Collinearity>(
    "collinearity", "1.0.0", "r_cs, r_oc: continuity of boundary lines, and what lies in the gap between them"))
