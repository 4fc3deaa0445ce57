// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contributions.h"

namespace gestalt {

namespace {
constexpr int replacements = 5;
}

std::vector<double> contributions(const Model& model, std::span<const double> values) {
  const double p = model.probability(values);
  std::vector<double> row(values.begin(), values.end()), result(values.size(), 0.0);
  for (std::size_t i = 0; i < row.size(); ++i) {
    const double low = model.scaling.low[i], high = model.scaling.high[i];
    if (!(low < high)) continue;
    double sum = 0;
    for (int k = 0; k < replacements; ++k) {
      row[i] = low + (high - low) * k / (replacements - 1);
      sum += model.probability(row);
    }
    row[i] = values[i];
    result[i] = p - sum / replacements;
  }
  return result;
}

}  // namespace gestalt
