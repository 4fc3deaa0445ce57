// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <cctype>

#include "frame_files.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_format.h"
#include "gestalt/io/scene/scene_names.h"
#include "gestalt/io/scene/scene_path.h"
#include "natural_order.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Whether a path may lead to a scene of which nothing can be seen: a folder that cannot be listed, a link to nowhere.
bool is_closed(const fs::path& path) {
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (fs::is_directory(status)) return fs::directory_iterator(path, error), bool(error);
  return !fs::exists(status) && fs::is_symlink(fs::symlink_status(path, error));
}

std::vector<fs::path> scenes_in(const fs::path& folder) {
  std::error_code error, ignored;
  std::vector<fs::path> scenes, folders;
  fs::directory_iterator entry(folder, error);
  for (; !error && entry != fs::directory_iterator(); entry.increment(error)) {
    const fs::path& path = entry->path();
    if (path.filename().string().starts_with('.')) continue;
    if (is_scene(path)) scenes.push_back(path);
    if (fs::is_directory(path, ignored)) folders.push_back(path);
  }
  if (error) throw InputError(folder.string() + ": cannot be listed: " + error.message());
  if (scenes.empty()) scenes = depth_images(folder);
  if (scenes.empty())
    for (const fs::path& recording : folders) {
      const std::vector<fs::path> frames = depth_images(recording);
      scenes.insert(scenes.end(), frames.begin(), frames.end());
    }
  if (scenes.empty())
    throw InputError(folder.string() + ": contains no scene (" + seen_in(folder) +
                     " there); give a folder with depth.png (and rgb.png), one with the folders depth/ and rgb/, a " +
                     scene_extensions(" or ") + " file, a folder of those, or --depth and --rgb");
  std::sort(scenes.begin(), scenes.end(), scene_less);
  return scenes;
}

}  // namespace

std::string lower_extension(const fs::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension;
}

bool is_scene(const fs::path& path) {
  // An image in a folder of scenes may be anything; it is a scene where it is named.
  const SceneFormat* const format = scene_format_of(path);
  return format ? format->name != "frame" : is_closed(path);
}

bool scene_less(const fs::path& a, const fs::path& b) {
  return natural_less(a.filename().string(), b.filename().string());
}

std::string scene_name(const fs::path& scene) {
  std::error_code error;
  fs::path path = fs::absolute(scene, error).lexically_normal();
  if (!path.has_filename()) path = path.parent_path();
  const std::string name = (fs::is_directory(path, error) ? path.filename() : path.stem()).string();
  // That of a file '...pcd' would put results beside the output folder.
  if (name == "." || name == "..")
    throw InputError(scene.string() + ": has the name '" + name +
                     "', which cannot be used for a folder of results; rename it");
  return name;
}

std::vector<fs::path> find_scenes(const std::vector<fs::path>& paths) {
  std::vector<fs::path> scenes;
  for (const fs::path& path : paths) {
    std::error_code error;
    const auto status = fs::status(path, error);
    if (status.type() == fs::file_type::not_found) throw InputError(path.string() + ": does not exist; check the path");
    if (error) throw InputError(path.string() + ": cannot be read: " + error.message());
    if (scene_format_of(path)) {
      scenes.push_back(path);
    } else if (status.type() == fs::file_type::directory) {
      const auto inside = scenes_in(path);
      scenes.insert(scenes.end(), inside.begin(), inside.end());
    } else {
      refuse_non_scene(path, "a folder of those");
    }
  }
  std::vector<NamedScene> named;
  for (const fs::path& scene : scenes) named.push_back({scene, scene_name(scene)});
  check_scene_names(named);
  return scenes;
}

}  // namespace gestalt
