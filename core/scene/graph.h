// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gestalt {

enum class Level : std::uint8_t { structural, assembly };

/// "structural" or "assembly": the level's section in a config.
inline const char* name_of(Level level) { return level == Level::structural ? "structural" : "assembly"; }

/// p(same object) of two surfaces, a < b.
struct Edge {
  int a;
  int b;
  double probability;  ///< in [0, 1]
  Level level;
  std::size_t row = 0;  ///< in the level's relation table
};

/// Nodes are surfaces, edges are pairs with a probability (paper, Section 7).
struct Graph {
  std::vector<int> sizes;   ///< pixels of each node
  std::vector<Edge> edges;  ///< sorted by (a, b); at most one for a pair
};

}  // namespace gestalt
