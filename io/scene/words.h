// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

namespace gestalt {

/// What stands between blanks in a line.
std::vector<std::string_view> words_of(std::string_view line);

}  // namespace gestalt
