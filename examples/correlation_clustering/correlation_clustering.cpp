// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "correlation_clustering.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <queue>

#include <gestalt/core/base/disjoint_sets.h>

namespace {

using Weights = std::vector<std::map<int, double>>;  // of each node to its neighbours

double log_odds(double p) {
  p = std::clamp(p, 1e-3, 1 - 1e-3);  // no single edge decides alone
  return std::log(p / (1 - p));
}

/// Joins the two groups of the largest weight between them, over and over, while it is positive.
std::vector<int> join_greedily(Weights between) {
  struct Candidate {
    double weight;
    int a, b;
    bool operator<(const Candidate& other) const {
      return std::tuple(weight, other.a, other.b) < std::tuple(other.weight, a, b);
    }
  };
  std::priority_queue<Candidate> candidates;
  const auto offer = [&](int a, int b, double weight) {
    if (weight > 0) candidates.push({weight, std::min(a, b), std::max(a, b)});
  };
  for (int a = 0; a < int(between.size()); ++a)
    for (const auto& [b, weight] : between[a])
      if (a < b) offer(a, b, weight);
  std::vector<int> joined_to(between.size());
  for (int a = 0; a < int(between.size()); ++a) joined_to[a] = a;
  while (!candidates.empty()) {
    const Candidate best = candidates.top();
    candidates.pop();
    const auto now = between[best.a].find(best.b);
    if (now == between[best.a].end() || now->second != best.weight) continue;  // joined or changed since
    joined_to[best.b] = best.a;
    between[best.a].erase(best.b);
    for (const auto& [other, weight] : between[best.b]) {
      between[other].erase(best.b);
      if (other == best.a) continue;
      const double sum = between[best.a][other] += weight;
      between[other][best.a] = sum;
      offer(best.a, other, sum);
    }
    between[best.b].clear();
  }
  for (int& group : joined_to)
    while (joined_to[group] != group) group = joined_to[group];
  return joined_to;
}

/// Moves patches, in turn, to the group to which their edges sum up highest, or out of all, until none gains.
void move_singly(const Weights& between, std::vector<int>& groups) {
  int unused = groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
  for (bool moved = true; moved;) {
    moved = false;
    for (int node = 0; node < int(groups.size()); ++node) {
      std::map<int, double> sums{{unused, 0.0}, {groups[node], 0.0}};
      for (const auto& [other, weight] : between[node]) sums[groups[other]] += weight;
      const auto best =
          std::max_element(sums.begin(), sums.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
      if (best->second <= sums[groups[node]] + 1e-9) continue;
      groups[node] = best->first;
      unused += best->first == unused;
      moved = true;
    }
  }
}

}  // namespace

const gestalt::Parameters<CorrelationClustering::Params>& CorrelationClustering::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>()
          .real("probability", &Params::probability, 0.001, 0.999, "", "of an edge that speaks neither for nor against")
          .real("assembly_weight", &Params::assembly_weight, 0, 100, "",
                "of edges of the assembly level beside those of patches that touch");
  return parameters;
}

double CorrelationClustering::weight(const gestalt::Edge& edge) const {
  const double weight = log_odds(edge.probability) - log_odds(params_.probability);
  return edge.level == gestalt::Level::assembly ? params_.assembly_weight * weight : weight;
}

std::vector<int> CorrelationClustering::solve(const gestalt::Graph& graph) const {
  Weights between(graph.sizes.size());
  for (const gestalt::Edge& edge : graph.edges) between[edge.a][edge.b] = between[edge.b][edge.a] = weight(edge);
  std::vector<int> groups = join_greedily(between);
  move_singly(between, groups);
  gestalt::DisjointSets numbered(int(groups.size()));
  std::map<int, int> first;
  for (int node = 0; node < int(groups.size()); ++node)
    numbered.join(first.emplace(groups[node], node).first->second, node);
  return numbered.groups();
}
