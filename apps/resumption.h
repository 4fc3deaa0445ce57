// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gestalt::app {

/// Names what a scene's result follows from: what run names (run_identity(), and how all scenes are to be read), the
/// path of the scene, the content of its files and of its camera file. Of a scene folder, all files count but those
/// that results have and those larger than any image. Results keep it as `config.identity`.
std::string result_identity(const std::string& run, const std::filesystem::path& scene);

/// Whether a folder has a result.json of that identity that names these files, and has all files that it names. An
/// unreadable one is none.
bool is_segmented(const std::filesystem::path& folder, const std::string& identity,
                  const std::vector<std::string>& wanted);

}  // namespace gestalt::app
