// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/scene_folder.h"
#include "gestalt/synthesis/synthesis.h"

namespace gestalt {

void write_scene(const SyntheticScene& scene, const std::filesystem::path& folder) {
  write_scene_folder(OutputPath(folder) / scene.frame.name,
                     {scene.frame.colour, depth_in_millimetres(scene.frame), scene.ground_truth});
}

}  // namespace gestalt
