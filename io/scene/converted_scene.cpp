// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/converted_scene.h"

#include "gestalt/core/pipeline/learning_set.h"

namespace gestalt {

ConvertedScene converted(const Input& input) {
  ConvertedScene scene;
  scene.camera = input.frame.camera;
  scene.images.colour = input.frame.colour;
  scene.images.depth = depth_in_millimetres(input.frame);
  scene.images.label = input.ground_truth;
  if (!scene.images.label.empty()) scene.objects = count_objects(scene.images.label);
  return scene;
}

}  // namespace gestalt
