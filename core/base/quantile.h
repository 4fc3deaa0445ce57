// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

namespace gestalt {

/// The smallest of the values, of which there is at least one, that a share q of them do not exceed.
inline double quantile(std::vector<double> values, double q) {
  const auto rank = std::ptrdiff_t(std::ceil(q * double(values.size())));
  const auto chosen = values.begin() + std::max<std::ptrdiff_t>(rank - 1, 0);
  std::nth_element(values.begin(), chosen, values.end());
  return *chosen;
}

}  // namespace gestalt
