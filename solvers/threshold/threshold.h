// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt {

/// The simplest decision: connected components over the edges whose p(same) reaches a threshold. One wrong edge joins
/// two objects, so it serves as the baseline for the others.
class Threshold final : public Solver {
 public:
  struct Params {
    double probability = 0.5;  ///< an edge joins when p(same) >= probability
  };
  static const Parameters<Params>& parameters();

  explicit Threshold(const Params& params) : params_(params) {}
  std::vector<int> solve(const Graph& graph) const override;

 private:
  Params params_;
};

}  // namespace gestalt
