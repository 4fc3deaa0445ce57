// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace gestalt::app {

/// Names what of a scene its result follows from: its path and the content of scene_files(), but of those that results
/// have and of those larger than any image. Results keep it with what names the run as `config.identity`.
std::string scene_identity(const std::filesystem::path& scene);

/// Whether a folder has a result.json of that identity that names these files, and has all files that it names, as
/// their digests there tell. An unreadable one is none.
bool is_segmented(const std::filesystem::path& folder, const std::string& identity,
                  const std::vector<std::string>& wanted);

}  // namespace gestalt::app
