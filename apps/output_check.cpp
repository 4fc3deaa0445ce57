// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "output_check.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_files.h"

namespace gestalt::app {

namespace fs = std::filesystem;

void require_not_read(const std::string& option, const fs::path& output, const std::vector<fs::path>& inputs) {
  const bool is_read = std::any_of(inputs.begin(), inputs.end(), [&](const fs::path& input) {
    std::error_code ignored;
    return fs::equivalent(output, input, ignored);
  });
  if (is_read)
    throw ConfigError(option + " " + output.string() + ": is read, and would be replaced; choose another " + option);
}

void require_of_no_scene(const std::string& option, const fs::path& output, const std::vector<fs::path>& scenes) {
  std::error_code ignored;
  if (!fs::exists(output, ignored)) return;
  for (const fs::path& scene : scenes) require_not_read(option, output, scene_files(scene));
}

}  // namespace gestalt::app
