// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "border_depth.h"

GESTALT_PLUGIN(gestalt::component<gestalt::BorderDepth>("border_depth", "1.0.0",
                                                        "r_di2, r_vd2: mean and variance of depth on the 2D border"))
