// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// An image of a scene in the layout of BOP, the benchmark for 6D object pose estimation.
struct BopImage {
  std::filesystem::path scene;
  int number = 0;
  std::filesystem::path depth;
};

/// All images of a scene, or of all scenes in a folder, that scene_camera.json names. Throws InputError.
GESTALT_EXPORT std::vector<BopImage> find_bop_images(const std::filesystem::path& folder);

/// "000001_000012": scene and image.
GESTALT_EXPORT std::string bop_name(const BopImage& image);

/// Camera and scale of depth from scene_camera.json; objects from mask_visib, where there are masks, everything else is
/// background. Throws InputError naming the file and the place.
GESTALT_EXPORT ConvertedScene read_bop_image(const BopImage& image, const ReadOptions& options = {});

}  // namespace gestalt
