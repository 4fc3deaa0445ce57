// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/frame.h"

namespace gestalt {

/// One scene as read from disk.
struct Input {
  std::filesystem::path path;            ///< the scene folder or the cloud file
  Frame frame;                           ///< frame.name is the folder's name, or the cloud's without extension
  cv::Mat_<std::uint16_t> ground_truth;  ///< label.png or the cloud's label field (see object_of_label()); else empty
  std::vector<int> point_pixels;         ///< unorganized clouds only: the pixel of each original point, -1 = outside
                                         ///< the image or without a finite position
};

/// Every scene below the given paths, in the given order, the scenes of a folder in natural order (learn2 before
/// learn10). A path is a scene folder (it holds depth.png), a .pcd file, or a folder of those. Throws InputError for a
/// path that does not exist or holds no scene, and for two scenes of the same name.
GESTALT_EXPORT std::vector<std::filesystem::path> find_scenes(const std::vector<std::filesystem::path>& paths);

/// Reads a scene folder or a PCD. camera overrides what is found: camera.yaml in the folder or the nearest parent; an
/// organized cloud without one gets intrinsics fitted to its points. Throws InputError.
GESTALT_EXPORT Input read_scene(const std::filesystem::path& path, const std::optional<Camera>& camera = std::nullopt);

/// Reads width, height, fx, fy, cx, cy and, where present, depth_scale (metres per unit of depth.png, default 0.001).
/// Throws InputError, with the place, for a missing or wrong value.
struct CameraFile {
  Camera camera;
  double depth_scale = 0.001;
};
GESTALT_EXPORT CameraFile read_camera(const std::filesystem::path& file);

}  // namespace gestalt
