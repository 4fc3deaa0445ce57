// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gestalt/core/plugin/plugin.h>

#include "coloured_regions.h"

GESTALT_PLUGIN(gestalt::component<ColouredRegions>("coloured_regions", "1.0.0",
                                                   "Connected pixels of like normals and colour"))
