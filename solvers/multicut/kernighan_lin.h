// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "weighted_graph.h"

namespace gestalt {

/// Improves a partition by Kernighan-Lin moves with joins (Keuper et al. 2015, Algorithm 2). Two groups with an edge
/// between them, or a group and an empty one, exchange nodes: whatever node gains most moves next, for better or worse,
/// and the best state on the way stays; or the two join. Rounds over all such pairs go on while one of them gains, up
/// to a fixed number of looks at nodes, so the time is bounded. groups: any numbers from 0 to the number of nodes - 1;
/// stays so.
void improve_by_moves(const WeightedGraph& graph, std::vector<int>& groups);

}  // namespace gestalt
