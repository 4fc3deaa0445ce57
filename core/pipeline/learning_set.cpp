// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/learning_set.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>

#include "gestalt/core/base/error.h"

namespace gestalt {

int count_objects(const cv::Mat_<std::uint16_t>& ground_truth) {
  std::set<int> objects;
  for (const std::uint16_t value : ground_truth)
    if (const int object = object_of_label(value); object > 1) objects.insert(object);
  return int(objects.size());
}

std::vector<int> surface_objects(const SurfaceSet& surfaces, const cv::Mat_<std::uint16_t>& ground_truth) {
  if (ground_truth.size() != surfaces.labels.size())
    throw InputError("ground truth is " + std::to_string(ground_truth.cols) + "x" + std::to_string(ground_truth.rows) +
                     ", the frame " + std::to_string(surfaces.labels.cols) + "x" +
                     std::to_string(surfaces.labels.rows) + "; use the label image of this frame");
  std::vector<int> objects;
  for (const Surface& surface : surfaces.surfaces) {
    std::map<int, int> votes;
    for (const int pixel : surface.pixels)
      if (const int object = object_of_label(ground_truth.ptr<std::uint16_t>()[pixel]); object > 0) ++votes[object];
    const auto most =
        std::max_element(votes.begin(), votes.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
    objects.push_back(most == votes.end() ? 0 : most->first);
  }
  return objects;
}

Samples labelled_pairs(const RelationTable& table, const std::vector<int>& objects) {
  Samples samples{table.names.size(), {}, {}};
  for (std::size_t i = 0; i < table.pairs.size(); ++i) {
    const int a = objects[std::size_t(table.pairs[i].a)], b = objects[std::size_t(table.pairs[i].b)];
    if (a == 0 || b == 0 || (a == 1 && b == 1)) continue;
    samples.positive.push_back(a == b);
    const std::span<const double> row = table.row(i);
    samples.values.insert(samples.values.end(), row.begin(), row.end());
  }
  return samples;
}

LearningScene make_learning_scene(const Pipeline& pipeline, const Frame& frame,
                                  const cv::Mat_<std::uint16_t>& ground_truth) {
  LearningScene scene{frame.name, pipeline.perceive(frame), {}};
  scene.objects = surface_objects(scene.percept.surfaces(), ground_truth);
  // Without images, patches and borders: most of the memory, and nothing that a decision looks at.
  SurfaceSet surfaces{scene.percept.surfaces().labels, scene.percept.surfaces().surfaces, {}};
  Frame without_images;
  without_images.name = frame.name;
  without_images.camera = frame.camera;
  scene.percept.scene = std::make_shared<const Scene>(std::move(without_images), PatchMap{}, std::move(surfaces));
  return scene;
}

Samples assembly_pairs(const LearningScene& scene, const std::vector<int>& structural_groups) {
  const RelationTable& all = scene.percept.assembly;
  RelationTable apart{all.names, {}, {}};
  for (const std::size_t i : assembly_rows(scene.percept, structural_groups)) {
    apart.pairs.push_back(all.pairs[i]);
    apart.values.insert(apart.values.end(), all.row(i).begin(), all.row(i).end());
  }
  return labelled_pairs(apart, scene.objects);
}

namespace {

/// Leaves evenly spread ones of the negative samples, so that a crowded scene, whose pairs grow with the square of its
/// patches, does not outweigh all others.
Samples with_few_negatives(const Samples& all, std::size_t largest) {
  const auto negatives = std::size_t(std::count(all.positive.begin(), all.positive.end(), 0));
  if (negatives <= largest) return all;
  Samples few{all.columns, {}, {}};
  std::size_t seen = 0;
  for (std::size_t i = 0; i < all.rows(); ++i) {
    if (!all.positive[i]) {
      const std::size_t before = seen++ * largest / negatives;
      if (before == seen * largest / negatives) continue;
    }
    few.positive.push_back(all.positive[i]);
    few.values.insert(few.values.end(), all.row(i).begin(), all.row(i).end());
  }
  return few;
}

Model learn_level(const Pipeline& pipeline, Level level, const std::vector<const LearningScene*>& scenes,
                  const std::function<Samples(const LearningScene&)>& samples_of) {
  ExpectedModel expected = pipeline.expected_model(level);
  // The same, unless somebody took columns out to learn without them.
  if (!scenes.empty()) expected.names = scenes.front()->percept.table(level).names;
  const LevelConfig& config =
      level == Level::structural ? pipeline.config().structural : pipeline.config().assembly.value();
  Samples samples{expected.names.size(), {}, {}};
  TrainingData training;
  for (const LearningScene* scene : scenes) {
    samples.append(with_few_negatives(samples_of(*scene), std::size_t(config.negatives)));
    training.scenes.push_back(scene->name);
  }
  try {
    return train_model(expected.classifier, expected.classifier_name, expected.names, samples, std::move(training),
                       config_hash(pipeline.config(), level));
  } catch (const ModelError& error) {
    throw ModelError(
        std::string(name_of(level)) + " level: " + error.what() +
        (level == Level::assembly ? ", with objects in parts that do not touch, or set levels=structural" : ""));
  }
}

}  // namespace

Models learn(const Pipeline& pipeline, const std::vector<const LearningScene*>& scenes) {
  Models models{
      learn_level(pipeline, Level::structural, scenes,
                  [](const LearningScene& scene) { return labelled_pairs(scene.percept.structural, scene.objects); }),
      {}};
  if (pipeline.config().with_assembly)
    models.assembly = learn_level(pipeline, Level::assembly, scenes, [&](const LearningScene& scene) {
      return assembly_pairs(scene, pipeline.structural_groups(scene.percept, models.structural));
    });
  return models;
}

}  // namespace gestalt
