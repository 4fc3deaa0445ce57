// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The candidates nearest to a mistyped word by edit distance, nearest first, at most three and none that is too far
/// (more than a third of the longer word, at least 2 edits).
GESTALT_EXPORT std::vector<std::string> closest(std::string_view word, const std::vector<std::string>& candidates);

/// "; did you mean 'gabor'?" or "" when nothing is close.
GESTALT_EXPORT std::string did_you_mean(std::string_view word, const std::vector<std::string>& candidates);

}  // namespace gestalt
