// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "normals.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Normals>("normals", "1.0.0",
                                                    "Recursive clustering of z-adaptive normals (Section 3)"))
