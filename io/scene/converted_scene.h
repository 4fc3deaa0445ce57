// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/io/scene/scene_folder.h"

namespace gestalt {

/// A scene ready to be written.
struct ConvertedScene {
  SceneImages images;
  Camera camera;
  int objects = 0;             ///< with at least one pixel that has depth
  double depth_scale = 0.001;  ///< metres for each unit of images.depth
};

/// The bytes of files that read_scene() reads: .npz; .pcd (organized) and .ply (without pixels that have no depth),
/// both binary, with colour and labels where the scene has them.
GESTALT_EXPORT std::string npz_scene(const ConvertedScene& scene);
GESTALT_EXPORT std::string pcd_scene(const ConvertedScene& scene);
GESTALT_EXPORT std::string ply_scene(const ConvertedScene& scene);

}  // namespace gestalt
