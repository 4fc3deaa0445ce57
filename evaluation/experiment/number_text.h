// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace gestalt {

/// A number with so many decimals, the same under any locale; "-0.0" is "0.0". What is not finite: "nan", "inf",
/// "-inf".
std::string number_text(double value, int decimals);

}  // namespace gestalt
