// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "kernighan_lin.h"

#include <algorithm>
#include <cstdint>
#include <set>

namespace gestalt {

namespace {

constexpr double least_gain = 1e-9;              // less is rounding
constexpr std::int64_t most_looks = 20'000'000;  // at a node; some 50 ms
constexpr int most_rounds = 20;

class Improvement {
 public:
  Improvement(const WeightedGraph& graph, std::vector<int>& groups)
      : graph_(graph),
        groups_(groups),
        members_(groups.size() + 1),
        gain_(groups.size()),
        side_(groups.size(), outside) {
    for (std::size_t node = 0; node < groups.size(); ++node) members_[std::size_t(groups[node])].insert(int(node));
  }

  void run() {
    std::set<int> changed;  // groups, in the last round
    for (std::size_t group = 0; group < members_.size(); ++group)
      if (!members_[group].empty()) changed.insert(int(group));
    for (int round = 0; round < most_rounds && !changed.empty() && looks_ < most_looks; ++round) {
      std::set<int> changing;
      for (const auto& [a, b] : pairs_to_try(changed))
        if (exchange(a, b)) {
          changing.insert(a);
          changing.insert(b);
        }
      changed = std::move(changing);
    }
  }

 private:
  static constexpr signed char outside = -1;

  /// Groups with an edge between them, of which one has changed; and each that has changed with an empty one.
  std::set<std::pair<int, int>> pairs_to_try(const std::set<int>& changed) const {
    std::set<std::pair<int, int>> pairs;
    const int empty = first_empty();
    for (const int group : changed) {
      for (const int node : members_[std::size_t(group)])
        for (const auto& [other, weight] : graph_[std::size_t(node)]) {
          const int there = groups_[std::size_t(other)];
          if (there != group) pairs.insert(std::minmax(group, there));
        }
      if (members_[std::size_t(group)].size() > 1) pairs.insert({group, empty});
    }
    return pairs;
  }

  int first_empty() const {
    int group = 0;
    while (!members_[std::size_t(group)].empty()) ++group;
    return group;
  }

  /// True when nodes have moved.
  bool exchange(int a, int b) {
    if (members_[std::size_t(a)].empty()) return false;  // since it was listed
    std::vector<int> nodes(members_[std::size_t(a)].begin(), members_[std::size_t(a)].end());
    const std::size_t first_of_b = nodes.size();
    nodes.insert(nodes.end(), members_[std::size_t(b)].begin(), members_[std::size_t(b)].end());
    if (nodes.size() < 2) return false;
    looks_ += std::int64_t(nodes.size()) * std::int64_t(nodes.size());
    if (looks_ > most_looks) return false;

    for (std::size_t i = 0; i < nodes.size(); ++i) side_[std::size_t(nodes[i])] = i < first_of_b ? 0 : 1;
    double joint = 0;  // weight between the two
    for (const int node : nodes) {
      double& gain = gain_[std::size_t(node)] = 0;
      for (const auto& [other, weight] : graph_[std::size_t(node)]) {
        if (side_[std::size_t(other)] == outside) continue;
        const bool across = side_[std::size_t(other)] != side_[std::size_t(node)];
        gain += across ? weight : -weight;
        if (across) joint += weight / 2;
      }
    }
    const std::vector<int> moves = best_moves(nodes, joint);
    for (const int node : nodes) side_[std::size_t(node)] = outside;
    for (const int node : moves) move(node, groups_[std::size_t(node)] == a ? b : a);
    return !moves.empty();
  }

  /// The nodes whose change of sides, one after the other, gains most; all of the second side where a join does.
  std::vector<int> best_moves(const std::vector<int>& nodes, double joint) {
    std::vector<int> moves, left = nodes;
    double sum = 0, best = least_gain;
    std::size_t best_count = 0;
    while (!left.empty()) {
      std::size_t next = 0;
      for (std::size_t i = 1; i < left.size(); ++i)
        if (gain_[std::size_t(left[i])] > gain_[std::size_t(left[next])]) next = i;
      const int node = left[next];
      left.erase(left.begin() + std::ptrdiff_t(next));
      sum += gain_[std::size_t(node)];
      moves.push_back(node);
      if (sum > best) {
        best = sum;
        best_count = moves.size();
      }
      signed char& side = side_[std::size_t(node)];
      side = 1 - side;
      for (const auto& [other, weight] : graph_[std::size_t(node)])
        if (side_[std::size_t(other)] != outside)
          gain_[std::size_t(other)] += side_[std::size_t(other)] == side ? -2 * weight : 2 * weight;
    }
    moves.resize(best_count);
    if (joint <= best) return moves;
    moves.clear();
    const int kept = groups_[std::size_t(nodes.front())];
    for (const int node : nodes)
      if (groups_[std::size_t(node)] != kept) moves.push_back(node);
    return moves;
  }

  void move(int node, int to) {
    members_[std::size_t(groups_[std::size_t(node)])].erase(node);
    members_[std::size_t(to)].insert(node);
    groups_[std::size_t(node)] = to;
  }

  const WeightedGraph& graph_;
  std::vector<int>& groups_;
  std::vector<std::set<int>> members_;  // of each group
  std::vector<double> gain_;            // of each node, should it change sides
  std::vector<signed char> side_;       // 0 or 1 in the current pair
  std::int64_t looks_ = 0;
};

}  // namespace

void improve_by_moves(const WeightedGraph& graph, std::vector<int>& groups) { Improvement(graph, groups).run(); }

}  // namespace gestalt
