// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gestalt/core/plugin/parameters.h>
#include <gestalt/core/plugin/solver.h>

/// Correlation clustering: the groups for which the sum of the weights within them is largest, an edge's weight being
/// its log odds less those of a probability that is neither here nor there. No number of groups has to be known, and
/// edges within a group that speak against it count, which connected components do not see. The optimum is NP-hard to
/// find: groups are joined greedily (GAEC; Keuper et al. 2015), then single patches move as long as the sum gains.
class CorrelationClustering final : public gestalt::Solver {
 public:
  struct Params {
    double probability = 0.7;    ///< of an edge that has no weight
    double assembly_weight = 1;  ///< of edges of the assembly level beside those of patches that touch
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit CorrelationClustering(const Params& params) : params_(params) {}
  std::vector<int> solve(const gestalt::Graph& graph) const override;

 private:
  double weight(const gestalt::Edge& edge) const;

  Params params_;
};
