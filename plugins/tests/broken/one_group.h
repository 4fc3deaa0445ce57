// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// A small component for plugins that are wrong in their manifest: every node in one group.
class OneGroup final : public Solver {
 public:
  struct Params {
    int group = 0;
  };
  static const Parameters<Params>& parameters() {
    static const auto p = Parameters<Params>().integer("group", &Params::group, 0, 9, "", "number of the group");
    return p;
  }

  explicit OneGroup(const Params& params) : group_(params.group) {}
  std::vector<int> solve(const Graph& graph) const override { return std::vector<int>(graph.sizes.size(), group_); }

 private:
  int group_;
};

}  // namespace gestalt
