// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "normal_estimation.h"

namespace gestalt {

/// Neighbourhood reorganisation after Calderon et al.: a normal is pulled towards those of its neighbours that are like
/// it, so that one beside a crease comes to be that of its own side. Defaults are those of the authors' published
/// program.
struct ReorganisationParams {
  int reorganisation_radius = 2;   ///< px, window of the neighbours
  double neighbour_weight = 1000;  ///< alpha
  double likeness = 0.001;         ///< beta: weight of a neighbour is (1 - d^2 / (d^2 + beta))^2 with d = |m_i - m_j|
  int rounds = 5;                  ///< at most; it ends early when no normal moves by 0.001
};

/// m_i <- normalise(n_i + alpha sum_j (1 - l_ij)^2 m_j) from m = n = map's normals on. Neighbours are pixels of the
/// window within Tolerances::squared_reach(). Curvature stays.
NormalMap reorganise(const Frame& frame, NormalMap map, const Tolerances& tolerances,
                     const ReorganisationParams& params);

}  // namespace gestalt
