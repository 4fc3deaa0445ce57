// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Where the camera of a scene is, when none is given.
enum class CameraPlace {
  camera_file,  ///< find_camera_file() alone
  points,       ///< there, else the points tell it
  scene         ///< in the scene itself, else in that file
};

/// What a scene is read from: one of scene_formats(). The commands, their help and messages go by that table, so that
/// a new format is its reader, a line of the table and one of docs/formats.md.
struct SceneFormat {
  std::string name;       ///< of `convert --from` and `--to`
  std::string extension;  ///< of its files, in small letters, ".pcd"; empty: a folder
  std::string summary;    ///< for help: "pcd: " and this
  std::string kind;       ///< what `gestalt info` calls a scene of it
  CameraPlace camera = CameraPlace::camera_file;

  /// Whether a folder is one; null for a format of files, which go by their extension.
  bool (*recognises)(const std::filesystem::path& folder) = nullptr;

  /// All but path and name of the Input. Throws InputError naming the file, the place and the remedy.
  Input (*read)(const std::filesystem::path& scene, const ReadOptions& options) = nullptr;

  /// What `gestalt info` tells before the scene is read, "kind" in place of the above; with "camera_from" when it
  /// cannot be read for want of a camera. Null: nothing.
  nlohmann::ordered_json (*facts)(const std::filesystem::path& scene, const ReadOptions& options) = nullptr;

  /// The bytes of a file that read() reads; null: convert does not write such files.
  std::string (*encode)(const ConvertedScene& scene) = nullptr;
};

/// Every format; the first is the scene folder.
GESTALT_EXPORT std::span<const SceneFormat> scene_formats();

/// That of a path, going by its names; null when it is not a scene.
GESTALT_EXPORT const SceneFormat* scene_format_of(const std::filesystem::path& path);

/// That of a name; null when there is none.
GESTALT_EXPORT const SceneFormat* find_scene_format(std::string_view name);

/// The extensions of scene files, as a sentence lists them: ".pcd, .ply or .npz" with last = " or ".
GESTALT_EXPORT std::string scene_extensions(std::string_view last);

/// Throws InputError for a file that is not a scene, naming what can be given, the last of which is other; for a
/// recording of ROS, how to make scenes of it.
[[noreturn]] void refuse_non_scene(const std::filesystem::path& file, const std::string& other);

}  // namespace gestalt
