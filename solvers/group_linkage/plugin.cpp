// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "group_linkage.h"

GESTALT_PLUGIN(gestalt::component<gestalt::GroupLinkage>(
    "group_linkage", "1.0.0", "graph_cut of the structural level, then average linkage of whole groups"))
