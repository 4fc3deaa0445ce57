// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace gestalt {

/// A straight piece of a closed chain of points.
struct ChainLine {
  std::size_t first;  ///< its points are first, first + 1, ..., first + count - 1, modulo the chain's length
  std::size_t count;
  std::array<Eigen::Vector2f, 2> ends;  ///< feet of the first and last point on the fitted line
};

/// Splits a closed chain where it deviates most from the straight connection until each piece is within tolerance of
/// it, joins neighbouring pieces that one line fits as well, and fits a line to each (least squares across the line).
/// Pieces are in order around the chain and cover it. Empty for a chain of less than two distinct points.
std::vector<ChainLine> split_into_lines(const std::vector<Eigen::Vector2f>& chain, float tolerance);

}  // namespace gestalt
