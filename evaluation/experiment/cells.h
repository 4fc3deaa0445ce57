// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <string>

#include "number_text.h"

namespace gestalt {

/// What stands in a table where there is no number.
inline const std::string no_number = "–";

inline std::string cell(double value, int decimals) {
  return std::isnan(value) ? no_number : number_text(value, decimals);
}

}  // namespace gestalt
