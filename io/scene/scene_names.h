// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// A scene with the name that its results, or what it is converted to, go by.
struct NamedScene {
  std::filesystem::path path;
  std::string name;
};

/// The one rule for all who write something for each scene below one folder: no two have the same name, and each name
/// can be that of a folder there. Throws InputError naming both paths.
GESTALT_EXPORT void check_scene_names(const std::vector<NamedScene>& scenes);

}  // namespace gestalt
