// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "gap_occlusion.h"

GESTALT_PLUGIN(gestalt::component<gestalt::GapOcclusion>(
    "gap_occlusion", "1.0.0", "r_go, r_gl: is the gap between two patches covered by something nearer?"))
