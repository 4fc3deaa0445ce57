// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/labelled_cloud.h"

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;

ConvertedScene read_labelled_cloud(const fs::path& file, LabelKind labels, const ReadOptions& options) {
  const Input input = read_scene(file, options);
  if (input.ground_truth.empty())
    throw InputError(file.string() + ": has no field label; give clouds with ground truth, a label for each point");
  ConvertedScene scene = converted(input);
  if (labels == LabelKind::objects) scene.images.label = labels_of_objects(input.ground_truth, scene.images.depth);
  scene.objects = count_objects(scene.images.label);
  if (scene.objects == 0)
    throw InputError(file.string() + ": its labels name no object; " +
                     (labels == LabelKind::objects
                          ? "all are 0, which is background"
                          : "objects are 20 to 29, 30 to 39 and so on. Where they are counted 1, 2, 3, ..., as in the "
                            "clouds of OSD 0.2, give --labels objects"));
  return scene;
}

}  // namespace gestalt
