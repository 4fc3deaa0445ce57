// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "colour_histogram.h"

GESTALT_PLUGIN(gestalt::component<gestalt::ColourHistogram>("colour_histogram", "1.0.0",
                                                            "r_co: similarity of the patch colours"))
