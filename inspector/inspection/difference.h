// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace gestalt {

/// The place of the first difference between two values, as "patches[3].rms", or "" when they are the same: numbers to
/// within a millionth of the larger, as another machine's may differ in the last digits. place is that of the values
/// themselves.
std::string first_difference(const nlohmann::json& a, const nlohmann::json& b, const std::string& place);

}  // namespace gestalt
