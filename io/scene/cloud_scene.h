// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <string>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// Scenes of clouds; how they become images is said at read_scene(). All throw InputError.

Input read_pcd_scene(const std::filesystem::path& file, const ReadOptions& options);
Input read_ply_scene(const std::filesystem::path& file, const ReadOptions& options);

/// What the header of a PCD file declares, as SceneFormat::facts.
nlohmann::ordered_json pcd_facts(const std::filesystem::path& file, const ReadOptions& options);

/// Binary, with colour and labels where the scene has them: .pcd (organized) and .ply (without pixels that have no
/// depth).
std::string encode_pcd_scene(const ConvertedScene& scene);
std::string encode_ply_scene(const ConvertedScene& scene);

}  // namespace gestalt
