// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// Two stages, as the paper's levels have them (Sections 5 and 6): the edges of the structural level make groups, by
/// the rule of graph_cut; then whole groups are joined by the evidence of all edges between them, of both levels. (The
/// paper puts all edges into one graph.)
///
/// The evidence is the mean of p(same) over the edges between two groups, an edge weighted by the product of its
/// patches' pixels: the share of pixel pairs that belong together. The most probable pair of groups joins first, ties
/// by node number; its means with a third group are averaged, weighted by pixels (average linkage); what is below
/// probability stays apart. Groups without an edge between them stay apart.
class GroupLinkage final : public Solver {
 public:
  struct Params {
    double k = 0.5;             ///< of graph_cut, structural level
    double probability = 0.72;  ///< smallest mean p(same) that joins two groups
  };
  static const Parameters<Params>& parameters();

  explicit GroupLinkage(const Params& params) : params_(params) {}
  std::vector<int> solve(const Graph& graph) const override;

 private:
  Params params_;
};

}  // namespace gestalt
