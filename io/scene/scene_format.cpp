// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_format.h"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "cloud_scene.h"
#include "folder_scene.h"
#include "frame_scene.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/scene_path.h"
#include "npz_scene.h"

namespace gestalt {

namespace fs = std::filesystem;

std::span<const SceneFormat> scene_formats() {
  using enum CameraPlace;
  static const std::vector<SceneFormat> formats{
      {"scene", "", "folders of images", "scene folder", camera_file, is_scene_folder, read_scene_folder},
      {"pcd", ".pcd", "clouds", "cloud", points, nullptr, read_pcd_scene, pcd_facts, encode_pcd_scene},
      {"ply", ".ply", "clouds", "PLY cloud", camera_file, nullptr, read_ply_scene, nullptr, encode_ply_scene},
      {"npz", ".npz", "arrays of numpy", "scene of arrays", scene, nullptr, read_npz_scene, nullptr, encode_npz_scene},
      {"frame", "", "depth images with their colour, one by one or in recordings", "frame", camera_file, is_frame,
       read_frame_scene},
  };
  return formats;
}

const SceneFormat* scene_format_of(const fs::path& path) {
  std::error_code ignored;
  const bool folder = fs::is_directory(path, ignored);
  const std::string extension = lower_extension(path);
  for (const SceneFormat& format : scene_formats())
    if (format.recognises ? format.recognises(path) : !folder && format.extension == extension) return &format;
  return nullptr;
}

const SceneFormat* find_scene_format(std::string_view name) {
  const auto formats = scene_formats();
  const auto found =
      std::find_if(formats.begin(), formats.end(), [&](const auto& format) { return format.name == name; });
  return found == formats.end() ? nullptr : &*found;
}

std::string scene_extensions(std::string_view last) {
  std::vector<std::string> extensions;
  for (const SceneFormat& format : scene_formats())
    if (!format.extension.empty()) extensions.push_back(format.extension);
  std::string text;
  for (std::size_t i = 0; i < extensions.size(); ++i)
    text.append(i == 0 ? "" : i + 1 < extensions.size() ? ", " : last).append(extensions[i]);
  return text;
}

void refuse_non_scene(const fs::path& file, const std::string& other) {
  const std::string extension = lower_extension(file);
  if (extension == ".bag" || extension == ".mcap" || extension == ".db3")
    throw InputError(file.string() + ": is a recording of ROS; make scenes of it with `gestalt convert " +
                     file.string() + " --output DIR`, then give DIR/scenes");
  throw InputError(file.string() + ": is not a scene; give a scene folder, a " + scene_extensions(" or ") +
                   " file, or " + other);
}

}  // namespace gestalt
