// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_names.h"

#include <map>
#include <string_view>

#include "gestalt/core/base/error.h"

namespace gestalt {

void check_scene_names(const std::vector<NamedScene>& scenes) {
  std::map<std::string, std::filesystem::path> names;
  for (const auto& [path, name] : scenes) {
    if (name.empty() || name == "." || name == ".." || name.find_first_of(std::string_view("/\0", 2)) != name.npos)
      throw InputError(path.string() + ": has the name '" + name +
                       "', which cannot be used for a folder of results; rename it");
    const auto [other, is_new] = names.emplace(name, path);
    if (is_new) continue;
    if (other->second == path) throw InputError(path.string() + ": is given twice; remove one");
    throw InputError(path.string() + ": has the same name as " + other->second.string() + ", '" + name +
                     "', so that one would replace the other; give them apart or rename one");
  }
}

}  // namespace gestalt
