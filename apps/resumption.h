// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "reading_options.h"

namespace gestalt::app {

/// Names what the results of all scenes follow from: this build, the config's values but its time budget, the content
/// of the model, and how scenes are to be read. Results keep it as `config.identity`.
std::string run_identity(const nlohmann::json& config, const std::filesystem::path& model,
                         const ReadingOptions& reading);

/// Whether the folder of a scene's results has a result.json of this run, newer than every file of the scene and its
/// camera file, that names these files, and has all files that it names. An unreadable one is none.
bool is_segmented(const std::filesystem::path& scene, const std::filesystem::path& folder, const std::string& identity,
                  const std::vector<std::string>& wanted);

}  // namespace gestalt::app
