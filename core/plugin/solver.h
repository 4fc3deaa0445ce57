// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/graph.h"

namespace gestalt {

/// Global decision (paper, Section 7): cuts the graph into objects.
class GESTALT_EXPORT Solver {
 public:
  virtual ~Solver();

  /// Group of each node, numbered from 0 in order of first appearance. Const, thread-safe, deterministic: ties are
  /// broken by node number.
  virtual std::vector<int> solve(const Graph& graph) const = 0;

  /// Which pairs of the assembly level are edges: false, those of different groups of the structural level alone, as
  /// the paper has it (Section 6), for which the solver runs twice; true, all, for a solver to which an edge within
  /// such a group tells that the group is wrong.
  virtual bool takes_all_pairs() const;
};

}  // namespace gestalt
