// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_files.h"

#include <functional>
#include <optional>
#include <set>

#include "frame_files.h"
#include "frame_scene.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"
#include "recording_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

class SceneFiles {
 public:
  explicit SceneFiles(const fs::path& scene) {
    std::error_code ignored;
    if (fs::is_directory(scene, ignored)) {
      add_folder(scene, [](const fs::path&) { return true; });
      for (const char* masks : {"masks", "mask_visib", "mask"})
        add_folder(scene / masks, [](const fs::path&) { return true; });
      add(camera_file_of_frame(scene / "depth.png", scene));
    } else {
      add(scene);
      add_folder(scene.parent_path().empty() ? "." : scene.parent_path(),
                 [&](const fs::path& file) { return file.stem() == scene.stem(); });
      if (is_frame(scene)) add_frame(scene);
      add(find_camera_file(scene));
    }
  }

  std::vector<fs::path> files() const { return {files_.begin(), files_.end()}; }

 private:
  void add(const std::optional<fs::path>& file) {
    std::error_code ignored;
    if (file && fs::is_regular_file(*file, ignored)) files_.insert(*file);
  }

  void add_folder(const fs::path& folder, const std::function<bool(const fs::path&)>& wanted) {
    std::error_code error;
    for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
         entry.increment(error))
      if (wanted(entry->path())) add(entry->path());
  }

  void add_frame(const fs::path& depth) {
    const fs::path recording = recording_of(depth);
    for (const char* list : {"associations.txt", "rgb.txt", "depth.txt"}) add(recording / list);
    add(camera_file_of_frame(depth, recording));
    try {
      add(files_of_frame(depth).colour);
    } catch (const InputError&) {  // reading the scene reports it
    }
  }

  std::set<fs::path> files_;
};

}  // namespace

std::vector<fs::path> scene_files(const fs::path& scene) { return SceneFiles(scene).files(); }

}  // namespace gestalt
