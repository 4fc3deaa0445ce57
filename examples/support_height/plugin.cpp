// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "support_height.h"

GESTALT_PLUGIN(gestalt::component<SupportHeight>("support_height", "1.0.0", "r_sh: height of a pair over its support"))
