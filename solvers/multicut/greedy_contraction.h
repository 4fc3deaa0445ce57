// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "weighted_graph.h"

namespace gestalt {

/// Greedy additive edge contraction: joins the two groups with the largest sum of weights between them, ties by node
/// number, while that is positive. Gives for each node the smallest of its group.
std::vector<int> contract_greedily(const WeightedGraph& graph);

}  // namespace gestalt
