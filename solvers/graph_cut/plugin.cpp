// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/plugin/plugin.h"

#include "graph_cut.h"

GESTALT_PLUGIN(gestalt::component<gestalt::GraphCut>(
    "graph_cut", "1.0.0", "Greedy graph-based segmentation of Felzenszwalb and Huttenlocher"))
