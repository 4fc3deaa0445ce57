// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "bspline.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Bspline>("bspline", "1.0.0",
                                                    "B-spline surface of least closest-point distances (Section 4.1)"))
