// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "border_colour.h"

GESTALT_PLUGIN(gestalt::component<gestalt::BorderColour>("border_colour", "1.0.0",
                                                         "r_co3: colour similarity across the common border"))
