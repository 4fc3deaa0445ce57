// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "greedy_contraction.h"

#include <algorithm>
#include <map>
#include <queue>
#include <tuple>

#include "gestalt/core/base/disjoint_sets.h"

namespace gestalt {

namespace {

struct Candidate {
  double weight;
  int a;  ///< a < b
  int b;

  bool operator<(const Candidate& other) const {
    return std::tie(weight, other.a, other.b) < std::tie(other.weight, a, b);
  }
};

}  // namespace

std::vector<int> contract_greedily(const WeightedGraph& graph) {
  std::vector<std::map<int, double>> sums(graph.size());  // of each group, to the others
  std::priority_queue<Candidate> candidates;
  const auto offer = [&](int a, int b, double weight) {
    if (weight > 0) candidates.push({weight, std::min(a, b), std::max(a, b)});
  };
  for (std::size_t a = 0; a < graph.size(); ++a)
    for (const auto& [b, weight] : graph[a]) {
      sums[a][b] = weight;
      if (int(a) < b) offer(int(a), b, weight);
    }

  DisjointSets groups(int(graph.size()));
  while (!candidates.empty()) {
    const auto [weight, a, b] = candidates.top();
    candidates.pop();
    auto& of_a = sums[std::size_t(a)];
    auto& of_b = sums[std::size_t(b)];
    const auto now = of_a.find(b);
    if (now == of_a.end() || now->second != weight) continue;  // joined, or another sum since
    groups.join(a, b);
    of_a.erase(now);
    for (const auto& [other, more] : of_b) {
      if (other == a) continue;
      auto& of_other = sums[std::size_t(other)];
      of_other.erase(b);
      of_other[a] = of_a[other] += more;
      offer(a, other, of_a[other]);
    }
    of_b.clear();
  }
  std::vector<int> smallest(graph.size());
  for (std::size_t i = 0; i < graph.size(); ++i) smallest[i] = groups.find(int(i));
  return smallest;
}

}  // namespace gestalt
