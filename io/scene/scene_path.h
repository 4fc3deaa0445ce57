// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// ".pcd" of "a/b.PCD".
GESTALT_EXPORT std::string lower_extension(const std::filesystem::path& file);

/// Whether a path is a scene, going by its names: a folder with depth.png or rgb.png, or a .pcd, .ply or .npz file. A
/// folder without its depth counts, so that it is reported when it is read, not lost.
GESTALT_EXPORT bool is_scene(const std::filesystem::path& path);

/// The order in which the scenes of a folder are read: that of their names, numbers by value (learn2 before learn10).
GESTALT_EXPORT bool scene_less(const std::filesystem::path& a, const std::filesystem::path& b);

}  // namespace gestalt
