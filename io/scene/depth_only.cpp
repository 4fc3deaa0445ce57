// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/depth_only.h"

#include <algorithm>

#include "gestalt/core/base/error.h"
#include "gestalt/core/config/loaded_config.h"

namespace gestalt {

namespace fs = std::filesystem;

fs::path depth_only_config() { return default_config().parent_path() / "depth_only.yaml"; }

bool depth_only_may_replace(const fs::path& config, const std::vector<std::string>& overrides) {
  const auto is_of_the_model = [](const std::string& assignment) {
    const std::string path = assignment.substr(0, assignment.find('='));
    return (path.starts_with("model") && assignment != "model=none") || path.find("relations") != path.npos ||
           path.find("classifier") != path.npos;
  };
  return config.empty() && std::none_of(overrides.begin(), overrides.end(), is_of_the_model);
}

bool none_has_colour(const std::vector<fs::path>& scenes, const ReadOptions& options) {
  bool any_read = false;
  for (const fs::path& scene : scenes) try {
      if (read_scene(scene, options).frame.has_colour()) return false;
      any_read = true;
    } catch (const Error&) {
      // The user of the scene reports it.
    }
  return any_read;
}

void require_colour_as_of_others(const Input& input) {
  if (!input.frame.has_colour())
    throw InputError(input.path.string() +
                     ": has no colour image, as other scenes of the set have; add it, take the scene out, or give "
                     "--config depth_only.yaml, by which depth alone counts in all of them");
}

}  // namespace gestalt
