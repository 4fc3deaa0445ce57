// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// ".pcd" of "a/b.PCD".
GESTALT_EXPORT std::string lower_extension(const std::filesystem::path& file);

/// Whether a path is a scene, going by its names: whether scene_formats() has one for it. A folder with rgb.png alone
/// counts, so that the missing depth is reported when it is read, not lost; so do a folder that cannot be listed and a
/// link that leads nowhere.
GESTALT_EXPORT bool is_scene(const std::filesystem::path& path);

/// The order in which the scenes of a folder are read: that of their names, numbers by value (learn2 before learn10).
GESTALT_EXPORT bool scene_less(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace gestalt
