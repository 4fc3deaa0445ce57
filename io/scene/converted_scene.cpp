// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/converted_scene.h"

#include "gestalt/core/pipeline/learning_set.h"

namespace gestalt {

ConvertedScene converted(const Input& input, double depth_scale) {
  ConvertedScene scene;
  scene.camera = input.frame.camera;
  scene.images.colour = input.frame.colour;
  scene.images.depth = depth_in_units(input.frame, depth_scale);
  scene.depth_scale = depth_scale;
  scene.warnings = input.warnings;
  scene.notes = input.notes;
  scene.images.label = input.ground_truth;
  if (!scene.images.label.empty()) scene.objects = count_objects(scene.images.label);
  return scene;
}

}  // namespace gestalt
