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
};

}  // namespace gestalt
