// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <numeric>
#include <span>

namespace gestalt {

/// Turns a histogram's counts into the square roots of its shares, the form that bhattacharyya() compares.
/// Counts without any entry stay zero.
inline void take_root_shares(std::span<float> counts) {
  const float total = std::accumulate(counts.begin(), counts.end(), 0.f);
  if (total == 0) return;
  for (float& count : counts) count = std::sqrt(count / total);
}

/// Bhattacharyya coefficient (the paper's Fidelity distance, Section 5), the sum of sqrt(P_i Q_i), of two histograms of
/// equal size given as root shares: 1 for equal histograms, 0 for those that share no bin.
inline double bhattacharyya(std::span<const float> p, std::span<const float> q) {
  double sum = 0;
  for (std::size_t i = 0; i < p.size(); ++i) sum += double(p[i]) * double(q[i]);
  return std::min(sum, 1.0);
}

}  // namespace gestalt
