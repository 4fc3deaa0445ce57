// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt {

/// One way to cut a scene's graph.
struct Cut {
  std::vector<int> labels;  ///< of each patch, the label of its segment, from 1
  std::vector<Role> roles;  ///< of each segment; that of label 1 comes first

  bool operator==(const Cut&) const = default;
};

Cut cut_of(const Segmentation& segmentation, std::size_t patches);

/// What becomes of the cut when one of the solver's parameters changes and all else stays as it is.
struct Sweep {
  Parameter parameter;         ///< a real one
  double current = 0;          ///< its value in the config
  std::vector<double> values;  ///< that were tried, ascending; current is one of them
  std::vector<int> cuts;       ///< of each value: index into Cuts::cuts
};

struct Cuts {
  std::vector<Cut> cuts;  ///< all different; the first is that of the config
  std::vector<Sweep> sweeps;
};

/// Values of a parameter to try: where its range is at most 10 wide, 61 spread evenly over it; else 61 from a 32nd to
/// 32 times its current value (of 1 where that is 0) in equal ratios, and the range's ends as far as they are within
/// 1e4. The current value is always among them. Ascending.
std::vector<double> sweep_values(const Parameter& parameter, double current);

/// Runs the decision for many values of each real parameter of the config's solver, one at a time: the pipeline's own
/// decision, with whatever solver it has.
Cuts sweep_solver(const Config& config, const Registry& registry, const Percept& percept, const Models& models);

}  // namespace gestalt
