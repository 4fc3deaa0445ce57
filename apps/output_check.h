// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gestalt::app {

/// Throws ConfigError, with the option's name, where a file that is to be written is one that is read.
void require_not_read(const std::string& option, const std::filesystem::path& output,
                      const std::vector<std::filesystem::path>& inputs);

/// The same where the inputs are the files of scenes.
void require_of_no_scene(const std::string& option, const std::filesystem::path& output,
                         const std::vector<std::filesystem::path>& scenes);

}  // namespace gestalt::app
