// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// Graph-based segmentation of Felzenszwalb and Huttenlocher (2004; paper, Section 7). Edges have the weight 1 -
/// p(same) and are taken in ascending order, ties by node number. An edge joins the components a and b of its ends when
///
///     w <= min(Int(a) + k / |a|, Int(b) + k / |b|)
///
/// Int is the largest weight that joined a component, 0 for a single node. A single patch so joins anything up to
/// w = k, and the larger a component, the more probable an edge must be.
class GraphCut final : public Solver {
 public:
  struct Params {
    double k = 0.5;                         ///< in units of size
    std::string size = "patches";           ///< what |a| counts: patches or pixels
    bool average_joined = true;             ///< see below
    std::string average_weight = "pixels";  ///< what weighs in the average: patches or pixels
  };

  /// With average_joined, when a join leaves two edges to one third component, both become one edge with their mean
  /// weight, weighted by the sizes of the two that were joined, and take the place of that weight in the order. One
  /// probable edge then no longer joins what all others keep apart. Without it, each edge stays as it is, as published.
  static const Parameters<Params>& parameters();

  explicit GraphCut(Params params) : params_(std::move(params)) {}
  std::vector<int> solve(const Graph& graph) const override;

 private:
  Params params_;
};

}  // namespace gestalt
