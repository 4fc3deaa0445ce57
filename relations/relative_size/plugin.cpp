// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "relative_size.h"

GESTALT_PLUGIN(gestalt::component<gestalt::RelativeSize>("relative_size", "1.0.0",
                                                         "r_rs: relative patch size similarity"))
