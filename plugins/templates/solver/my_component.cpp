#include "my_component.h"

#include <gestalt/core/base/disjoint_sets.h>

#include <algorithm>

const gestalt::Parameters<MyComponent::Params>& MyComponent::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>()
          .real("join", &Params::join, 0, 1, "", "an edge of less probability does not join")
          .real("veto", &Params::veto, 0, 1, "", "an edge of less probability keeps the groups of its patches apart");
  return parameters;
}

std::vector<int> MyComponent::solve(const gestalt::Graph& graph) const {
  std::vector<gestalt::Edge> edges = graph.edges;
  std::stable_sort(edges.begin(), edges.end(), [](const gestalt::Edge& x, const gestalt::Edge& y) {
    return x.probability > y.probability;  // equal ones stay in the order of their nodes
  });
  gestalt::DisjointSets groups(int(graph.sizes.size()));
  const auto vetoed = [&](int a, int b) {
    return std::any_of(graph.edges.begin(), graph.edges.end(), [&](const gestalt::Edge& edge) {
      return edge.probability < params_.veto &&
             std::minmax(groups.find(edge.a), groups.find(edge.b)) == std::minmax(a, b);
    });
  };
  for (const gestalt::Edge& edge : edges) {
    if (edge.probability < params_.join) break;
    const int a = groups.find(edge.a), b = groups.find(edge.b);
    if (a != b && !vetoed(a, b)) groups.join(a, b);
  }
  return groups.groups();
}
