// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "border_curvature.h"

GESTALT_PLUGIN(gestalt::component<gestalt::BorderCurvature>(
    "border_curvature", "1.0.0", "r_cu3, r_cv3: mean and variance of curvature on the 3D border"))
