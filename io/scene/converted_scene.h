// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_folder.h"

namespace gestalt {

/// A scene ready to be written.
struct ConvertedScene {
  SceneImages images;
  Camera camera;
  int objects = 0;                    ///< with at least one pixel that has depth
  double depth_scale = 0.001;         ///< metres for each unit of images.depth
  std::vector<std::string> warnings;  ///< as Input::warnings
  std::vector<std::string> notes;     ///< as Input::notes
};

/// Any scene that read_scene() reads, ready to be written; depth in units of so many metres. Throws InputError for a
/// depth of more than 65535 of them.
GESTALT_EXPORT ConvertedScene converted(const Input& input, double depth_scale = 0.001);

}  // namespace gestalt
