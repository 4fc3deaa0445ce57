// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gestalt {

/// A percentage of ours and the paper's. Both are numbers.
struct ComparedCell {
  std::string row;
  std::string column;
  double ours;
  double paper;

  double difference() const { return ours - paper; }
};

/// The cells of a table that the paper has, too.
using Comparison = std::vector<ComparedCell>;

/// Number of cells that differ by at most so many points.
int count_within(const Comparison& cells, double points);

/// Whether a cell of the column is more than so many points above the paper's.
bool exceeds(const Comparison& cells, const std::string& column, double points);

/// Whether one is more than so many points below.
bool falls_short(const Comparison& cells, const std::string& column, double points);

/// The cells that differ by more than so many points, by column: "P of r_co (+2.5), r_rs (-3.1); R of every row (+2.2
/// to +4.0)". Empty when there is none.
std::string differences_in_words(const Comparison& cells, double points);

}  // namespace gestalt
