// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <map>
#include <queue>
#include <tuple>
#include <vector>

#include "gestalt/core/scene/graph.h"

namespace gestalt {

/// The edges between components, averaged at joins, and a queue of them. A queue entry counts only while its link still
/// has the entry's revision; so nothing is ever searched for in the queue.
///
/// Weights leave the queue in ascending order: a mean is never below the smaller edge, and both are still to come or
/// were taken and refused.
class Links {
 public:
  Links(const Graph& graph, std::vector<double> sizes) : links_(graph.sizes.size()), sizes_(std::move(sizes)) {
    for (const Edge& edge : graph.edges) put(edge.a, edge.b, 1 - edge.probability);
  }

  struct Candidate {
    double weight;
    int a;  ///< a < b
    int b;
    int revision;

    bool operator>(const Candidate& o) const { return std::tie(weight, a, b) > std::tie(o.weight, o.a, o.b); }
  };

  /// Takes the link of the smallest weight; false when none is left.
  bool take(Candidate& best) {
    while (!queue_.empty()) {
      best = queue_.top();
      queue_.pop();
      const auto& of_a = links_[std::size_t(best.a)];
      const auto link = of_a.find(best.b);
      if (link != of_a.end() && link->second.revision == best.revision) return true;
    }
    return false;
  }

  /// Gives the links of b to a and averages those that both have. a < b.
  void join(int a, int b) {
    const double size_a = sizes_[std::size_t(a)], size_b = sizes_[std::size_t(b)];
    links_[std::size_t(a)].erase(b);
    for (const auto& [other, link] : links_[std::size_t(b)]) {
      if (other == a) continue;
      links_[std::size_t(other)].erase(b);
      const auto both = links_[std::size_t(a)].find(other);
      put(a, other,
          both == links_[std::size_t(a)].end()
              ? link.weight
              : (size_a * both->second.weight + size_b * link.weight) / (size_a + size_b));
    }
    links_[std::size_t(b)].clear();
    sizes_[std::size_t(a)] = size_a + size_b;
  }

 private:
  struct Link {
    double weight;
    int revision;
  };

  void put(int a, int b, double weight) {
    const Link link{weight, ++revision_};
    links_[std::size_t(a)][b] = links_[std::size_t(b)][a] = link;
    queue_.push({weight, std::min(a, b), std::max(a, b), link.revision});
  }

  std::vector<std::map<int, Link>> links_;  // of each component, by the other end; each link stands at both ends
  std::vector<double> sizes_;
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> queue_;
  int revision_ = 0;
};

}  // namespace gestalt
