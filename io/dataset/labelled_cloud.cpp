// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/labelled_cloud.h"

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/ground_truth.h"

namespace gestalt {

namespace fs = std::filesystem;

ConvertedScene read_labelled_cloud(const fs::path& file, const ReadOptions& options) {
  const Input input = read_scene(file, options);
  if (input.ground_truth.empty() && input.ground_truth_problem.empty()) {
    if (options.labels == LabelScheme::guess) return converted(input);
    throw InputError(file.string() + ": has no field 'label'; omit --labels");
  }
  require_ground_truth(input);
  ConvertedScene scene = converted(input);
  if (scene.objects == 0)
    throw InputError(file.string() +
                     ": its labels name no object; 0 to 9 are background, objects are 20 to 29, 30 to 39 and so on. "
                     "Where they are numbered 1, 2, 3, ..., as in the clouds of OSD 0.2, give --labels objects");
  return scene;
}

}  // namespace gestalt
