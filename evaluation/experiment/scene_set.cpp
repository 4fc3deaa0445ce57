// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_set.h"

#include <optional>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/evaluation/score/scene_sets.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_files.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

std::string contents(const fs::path& scene) {
  std::string text;
  for (const fs::path& file : scene_files(scene)) text += " " + file.filename().string() + " " + file_digest(file);
  return text;
}

std::string text_of(const CameraFile& camera) {
  if (!camera.file.empty()) return file_digest(camera.file);
  std::string text;
  for (const double number : {camera.camera.fx, camera.camera.fy, camera.camera.cx, camera.camera.cy})
    text += std::to_string(number) + " ";
  return text;
}

/// Empty for default options, so that earlier results stay valid.
std::string text_of(const ReadOptions& read) {
  std::string text;
  if (read.camera) text += "camera " + text_of(*read.camera) + "\n";
  if (read.depth_scale) text += "depth_scale " + std::to_string(*read.depth_scale * 1e9) + "\n";
  if (read.depth_kind != DepthKind::plain) text += "depth_kind " + std::to_string(int(read.depth_kind)) + "\n";
  if (read.labels != LabelScheme::guess) text += "labels " + std::to_string(int(read.labels)) + "\n";
  return text;
}

}  // namespace

SceneSet::SceneSet(const Protocol& protocol) : read(protocol.read) {
  const auto append = [&](const std::vector<fs::path>& paths, bool learnt, bool scored) {
    const std::vector<std::string> categories = scene_categories(paths);
    for (std::size_t i = 0; i < paths.size(); ++i)
      scenes.push_back({paths[i], scene_name(paths[i]), categories[i], learnt, scored});
  };
  const bool cross_validation = protocol.test.empty();
  append(protocol.learn, true, cross_validation);
  append(protocol.test, false, true);
  if (cross_validation) {
    folds = protocol.folds;
    fold = deal_folds(scene_categories(protocol.learn), folds, protocol.seed);
    for (std::size_t i = 0; i < scenes.size(); ++i) scenes[i].model = fold[i];
  }
  for (std::size_t set = 0; set < protocol.further.size(); ++set)
    for (const fs::path& path : protocol.further[set].scenes)
      scenes.push_back({path, scene_name(path), protocol.further[set].name, false, true, folds, int(set)});
}

std::string canonical(const SceneSet& set) {
  std::vector<std::string> texts(set.scenes.size());
  for_all(texts.size(), [&](std::size_t i) {
    const SceneUse& scene = set.scenes[i];
    texts[i] = std::string(scene.learnt        ? "learn "
                           : scene.further < 0 ? "test "
                                               : "further ") +
               scene.name + " [" + scene.category + "] model " + std::to_string(scene.model) + contents(scene.path) +
               "\n";
  });
  std::string text = "folds " + std::to_string(set.folds) + "\n" + text_of(set.read);
  for (const std::string& scene : texts) text += scene;
  return text;
}

}  // namespace gestalt
