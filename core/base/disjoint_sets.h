// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <numeric>
#include <vector>

namespace gestalt {

/// Sets of the numbers 0..n-1 that can be joined. A set is represented by its smallest member, so that the result of a
/// series of joins does not depend on their direction.
class DisjointSets {
 public:
  explicit DisjointSets(int n) : parent_(std::size_t(n)) { std::iota(parent_.begin(), parent_.end(), 0); }

  /// The smallest member of the set of i.
  int find(int i) {
    while (parent(i) != i) i = parent(i) = parent(parent(i));
    return i;
  }

  /// Joins the sets of a and b; returns the smallest member of the result.
  int join(int a, int b) {
    const auto [kept, gone] = std::minmax({find(a), find(b)});
    return parent(gone) = kept;
  }

  /// Set of each number; sets are numbered from 0 in order of first appearance.
  std::vector<int> groups() {
    std::vector<int> group(parent_.size());
    int count = 0;
    for (int i = 0; i < int(group.size()); ++i) {
      const int first = find(i);
      group[std::size_t(i)] = first == i ? count++ : group[std::size_t(first)];
    }
    return group;
  }

 private:
  int& parent(int i) { return parent_[std::size_t(i)]; }

  std::vector<int> parent_;
};

}  // namespace gestalt
