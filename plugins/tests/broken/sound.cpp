// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Nothing is wrong with this one: it is what the others deviate from.

#include "gestalt/core/plugin/plugin.h"
#include "one_group.h"

GESTALT_PLUGIN(gestalt::component<gestalt::OneGroup>("one_group", "1.2.3", "Every node in one group"))
