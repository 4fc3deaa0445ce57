// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

struct Assigned {
  int row;
  int column;
};

/// The one-to-one assignment of rows to columns with the largest total weight; min(rows, columns) pairs, sorted by row.
/// Weights are finite. Among equally good assignments it gives the one that scipy.optimize.linear_sum_assignment gives,
/// so that scores that depend on pairs of weight 0 are reproducible. O(n^2 m) for n <= m.
/// Shortest augmenting paths after D. F. Crouse, "On implementing 2D rectangular assignment algorithms", IEEE
/// Transactions on Aerospace and Electronic Systems 52(4), 2016.
GESTALT_EXPORT std::vector<Assigned> largest_assignment(const Eigen::MatrixXd& weights);

}  // namespace gestalt
