// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "threshold.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Threshold>("threshold", "1.0.0",
                                                      "Connected components of the edges that are probable enough"))
