// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "threshold.h"

#include "gestalt/core/base/disjoint_sets.h"

namespace gestalt {

const Parameters<Threshold::Params>& Threshold::parameters() {
  static const auto p = Parameters<Params>().real("probability", &Params::probability, 0, 1, "",
                                                  "an edge joins its two patches when p(same) is at least this");
  return p;
}

std::vector<int> Threshold::solve(const Graph& graph) const {
  DisjointSets objects(int(graph.sizes.size()));
  for (const Edge& edge : graph.edges)
    if (edge.probability >= params_.probability) objects.join(edge.a, edge.b);
  return objects.groups();
}

}  // namespace gestalt
