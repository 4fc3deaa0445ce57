// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "folder_scene.h"

#include "frame_scene.h"
#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

bool is_scene_folder(const fs::path& folder) {
  std::error_code error;
  if (fs::exists(folder / "depth.png", error) || fs::exists(folder / "rgb.png", error)) return true;
  return has_scene_images(folder);
}

Input read_scene_folder(const fs::path& folder, const ReadOptions& options) {
  const FrameFiles files = files_of_scene_folder(folder);
  if (files.depth.empty())
    throw InputError(
        folder.string() + ": " + seen_in(folder) +
        " there, but no depth image; put it there as depth.png of 16-bit grey (or .tiff, .pgm, .exr, .npy)");
  return read_frame_files(files, folder, folder, options, GroundTruth::beside);
}

}  // namespace gestalt
