// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "common_height.h"

GESTALT_PLUGIN(gestalt::component<gestalt::CommonHeight>("common_height", "1.0.0",
                                                         "r_th: difference of the heights at which two patches end"))
