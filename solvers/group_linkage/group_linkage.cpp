// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "group_linkage.h"

#include <algorithm>
#include <map>

#include "gestalt/core/base/disjoint_sets.h"
#include "graph_cut.h"
#include "links.h"

namespace gestalt {

namespace {

Graph structural_part(const Graph& graph) {
  Graph part{graph.sizes, {}};
  for (const Edge& edge : graph.edges)
    if (edge.level == Level::structural) part.edges.push_back(edge);
  return part;
}

/// A node for each group, and between two groups the mean of their edges.
Graph contract(const Graph& graph, const std::vector<int>& groups) {
  struct Mean {
    double sum = 0, weight = 0;
  };
  std::map<std::pair<int, int>, Mean> means;
  for (const Edge& edge : graph.edges) {
    const auto [a, b] = std::minmax(groups[std::size_t(edge.a)], groups[std::size_t(edge.b)]);
    if (a == b) continue;
    const double weight = double(graph.sizes[std::size_t(edge.a)]) * double(graph.sizes[std::size_t(edge.b)]);
    Mean& mean = means[{a, b}];
    mean.sum += weight * edge.probability;
    mean.weight += weight;
  }
  Graph contracted;
  contracted.sizes.resize(groups.empty() ? 0 : std::size_t(1 + *std::max_element(groups.begin(), groups.end())));
  for (std::size_t i = 0; i < groups.size(); ++i) contracted.sizes[std::size_t(groups[i])] += graph.sizes[i];
  for (const auto& [pair, mean] : means)
    contracted.edges.push_back({pair.first, pair.second, mean.sum / mean.weight, Level::assembly});
  return contracted;
}

std::vector<int> link(const Graph& graph, double probability) {
  Links links(graph, {graph.sizes.begin(), graph.sizes.end()});
  DisjointSets sets(int(graph.sizes.size()));
  for (Links::Candidate edge{}; links.take(edge) && 1 - edge.weight >= probability;) {
    sets.join(edge.a, edge.b);
    links.join(edge.a, edge.b);
  }
  return sets.groups();
}

}  // namespace

const Parameters<GroupLinkage::Params>& GroupLinkage::parameters() {
  static const auto p =
      Parameters<Params>()
          .real("k", &Params::k, 0, 1e9, "", "of graph_cut, which makes the groups of the structural level")
          .real("probability", &Params::probability, 0, 1, "", "smallest mean p(same) that joins two groups");
  return p;
}

std::vector<int> GroupLinkage::solve(const Graph& graph) const {
  const std::vector<int> groups = GraphCut({.k = params_.k}).solve(structural_part(graph));
  const std::vector<int> joined = link(contract(graph, groups), params_.probability);
  std::vector<int> result;
  for (const int group : groups) result.push_back(joined[std::size_t(group)]);
  return result;
}

}  // namespace gestalt
