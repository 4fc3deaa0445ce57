// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multicut.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "greedy_contraction.h"
#include "kernighan_lin.h"

namespace gestalt {

namespace {

double log_odds(double p) {
  p = std::clamp(p, 1e-3, 1 - 1e-3);
  return std::log(p / (1 - p));
}

/// The same groups, numbered from 0 in order of first appearance.
std::vector<int> numbered(const std::vector<int>& groups) {
  std::unordered_map<int, int> numbers;
  std::vector<int> result;
  for (const int group : groups) result.push_back(numbers.emplace(group, int(numbers.size())).first->second);
  return result;
}

}  // namespace

const Parameters<Multicut::Params>& Multicut::parameters() {
  static const auto p =
      Parameters<Params>()
          .real("structural_probability", &Params::structural_probability, 0.001, 0.999, "",
                "p(same) of an edge of the structural level that speaks neither for nor against a join")
          .real("assembly_probability", &Params::assembly_probability, 0.001, 0.999, "",
                "the same of the assembly level")
          .real("assembly_weight", &Params::assembly_weight, 0, 1000, "",
                "what edges of the assembly level count beside those of the structural level");
  return p;
}

double Multicut::weight(const Edge& edge) const {
  if (edge.level == Level::structural) return log_odds(edge.probability) - log_odds(params_.structural_probability);
  return params_.assembly_weight * (log_odds(edge.probability) - log_odds(params_.assembly_probability));
}

std::vector<int> Multicut::solve(const Graph& graph) const {
  WeightedGraph weighted(graph.sizes.size());
  for (const Edge& edge : graph.edges) {
    weighted[std::size_t(edge.a)].emplace_back(edge.b, weight(edge));
    weighted[std::size_t(edge.b)].emplace_back(edge.a, weight(edge));
  }
  std::vector<int> groups = contract_greedily(weighted);
  improve_by_moves(weighted, groups);
  return numbered(groups);
}

}  // namespace gestalt
