// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "comparison.h"

#include <algorithm>
#include <cmath>

#include "number_text.h"

namespace gestalt {

namespace {

bool is_far(const ComparedCell& cell, double points) { return std::abs(cell.difference()) > points; }

std::string signed_points(double difference) {
  const std::string text = number_text(difference, 1);
  return text.starts_with('-') ? text : "+" + text;
}

/// The cells of a column that are far off. If all of three or more are, on the same side, only their range is given.
std::string column_in_words(const Comparison& column, double points) {
  Comparison far;
  std::copy_if(column.begin(), column.end(), std::back_inserter(far),
               [&](const ComparedCell& cell) { return is_far(cell, points); });
  if (far.empty()) return {};
  const auto by_difference = [](const ComparedCell& x, const ComparedCell& y) {
    return x.difference() < y.difference();
  };
  const auto [least, most] = std::minmax_element(far.begin(), far.end(), by_difference);
  const bool one_side = least->difference() > 0 || most->difference() < 0;
  if (far.size() == column.size() && far.size() > 2 && one_side)
    return far.front().column + " of every row (" + signed_points(least->difference()) + " to " +
           signed_points(most->difference()) + ")";
  std::string text;
  for (const ComparedCell& cell : far)
    text += (text.empty() ? cell.column + " of " : ", ") + cell.row + " (" + signed_points(cell.difference()) + ")";
  return text;
}

}  // namespace

int count_within(const Comparison& cells, double points) {
  return int(
      std::count_if(cells.begin(), cells.end(), [&](const ComparedCell& cell) { return !is_far(cell, points); }));
}

bool exceeds(const Comparison& cells, const std::string& column, double points) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const ComparedCell& cell) { return cell.column == column && cell.difference() > points; });
}

bool falls_short(const Comparison& cells, const std::string& column, double points) {
  return std::any_of(cells.begin(), cells.end(),
                     [&](const ComparedCell& cell) { return cell.column == column && cell.difference() < -points; });
}

std::string differences_in_words(const Comparison& cells, double points) {
  std::vector<std::string> columns;
  for (const ComparedCell& cell : cells)
    if (std::find(columns.begin(), columns.end(), cell.column) == columns.end()) columns.push_back(cell.column);
  std::string text;
  for (const std::string& name : columns) {
    Comparison column;
    std::copy_if(cells.begin(), cells.end(), std::back_inserter(column),
                 [&](const ComparedCell& cell) { return cell.column == name; });
    const std::string words = column_in_words(column, points);
    if (!words.empty()) text += (text.empty() ? "" : "; ") + words;
  }
  return text;
}

}  // namespace gestalt
