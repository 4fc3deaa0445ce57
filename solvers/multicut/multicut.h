// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// Minimum cost multicut (correlation clustering): the partition with the largest sum of edge weights within its
/// groups. The weight of an edge is how much its log-odds log(p / (1 - p)) exceed those of the level's neutral
/// probability, so an edge may speak against a join as well as for it, and edges of the assembly level count as much as
/// those of neighbours: they are lifted edges (Horňáková, Lange, Andres, ICML 2017), but that a group need not be
/// connected, as an occluder may divide an object.
///
/// Greedy additive edge contraction, then Kernighan-Lin moves with joins (Keuper et al., Efficient decomposition of
/// image and mesh graphs by lifted multicuts, ICCV 2015). The problem is NP-hard; of random graphs of eight nodes, more
/// than nine in ten are solved exactly (multicut_test.cpp).
class Multicut final : public Solver {
 public:
  struct Params {
    double structural_probability = 0.4;  ///< at which an edge of this level has no weight
    double assembly_probability =
        0.7;                       ///< the same; higher, as a wrong join of parts that do not touch is seldom undone
    double assembly_weight = 1.5;  ///< factor of the weights of this level
  };
  static const Parameters<Params>& parameters();

  explicit Multicut(const Params& params) : params_(params) {}
  std::vector<int> solve(const Graph& graph) const override;
  bool takes_all_pairs() const override { return true; }

  /// > 0: the patches belong together. Probabilities are clamped to [0.001, 0.999], so that no edge decides alone.
  double weight(const Edge& edge) const;

 private:
  Params params_;
};

}  // namespace gestalt
