// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "gabor.h"

GESTALT_PLUGIN(gestalt::component<gestalt::Gabor>(
    "gabor", "1.0.0", "r_ga: Gabor filter match, difference of texture whatever its direction"))
