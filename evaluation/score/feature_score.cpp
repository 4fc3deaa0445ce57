// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/feature_score.h"

#include <array>
#include <limits>

namespace gestalt {

namespace {

double square(double x) { return x * x; }

double feature_score(const Samples& samples, std::size_t column) {
  std::array<double, 2> sum{}, count{};
  for (std::size_t i = 0; i < samples.rows(); ++i) {
    sum[samples.positive[i]] += samples.row(i)[column];
    count[samples.positive[i]] += 1;
  }
  if (count[0] < 2 || count[1] < 2) return std::numeric_limits<double>::quiet_NaN();
  const std::array<double, 2> mean{sum[0] / count[0], sum[1] / count[1]};
  const double all = (sum[0] + sum[1]) / (count[0] + count[1]);
  std::array<double, 2> spread{};
  for (std::size_t i = 0; i < samples.rows(); ++i) {
    const std::uint8_t kind = samples.positive[i];
    spread[kind] += square(samples.row(i)[column] - mean[kind]);
  }
  const double between = square(mean[0] - all) + square(mean[1] - all);
  const double within = spread[0] / (count[0] - 1) + spread[1] / (count[1] - 1);
  if (between == 0) return 0;
  return within > 0 ? between / within : std::numeric_limits<double>::infinity();
}

}  // namespace

std::vector<double> feature_scores(const Samples& samples) {
  std::vector<double> scores;
  for (std::size_t column = 0; column < samples.columns; ++column) scores.push_back(feature_score(samples, column));
  return scores;
}

}  // namespace gestalt
