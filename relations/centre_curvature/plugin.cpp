// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "centre_curvature.h"

GESTALT_PLUGIN(gestalt::component<gestalt::CentreCurvature>(
    "centre_curvature", "1.0.0", "r_cc, r_cd: curvature from centre to centre of two patches"))
