// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace gestalt::app {

/// Suggests a command on stderr, as a shell reads its words, where stderr is a terminal: scripts need no suggestions.
void suggest_next(const std::string& purpose, const std::vector<std::string>& words);

}  // namespace gestalt::app
