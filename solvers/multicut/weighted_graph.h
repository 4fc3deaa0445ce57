// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

namespace gestalt {

/// The edges of each node: the other end, and the weight. An edge is in the lists of both of its ends.
using WeightedGraph = std::vector<std::vector<std::pair<int, double>>>;

}  // namespace gestalt
