// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/cross_validation.h"

#include "gestalt/core/base/for_all.h"

namespace gestalt {

namespace {

void count(const Samples& samples, const Model& model, PairDecisions& decisions) {
  for (std::size_t i = 0; i < samples.rows(); ++i)
    decisions.count(samples.positive[i], model.probability(samples.row(i)));
}

}  // namespace

std::vector<Models> learn_folds(const Pipeline& pipeline, const std::vector<const LearningScene*>& scenes,
                                const std::vector<int>& fold, int folds,
                                const std::vector<const LearningScene*>& additional) {
  std::vector<Models> models{std::size_t(folds)};
  for_all(models.size(), [&](std::size_t held_out) {
    std::vector<const LearningScene*> others;
    for (std::size_t i = 0; i < scenes.size(); ++i)
      if (fold[i] != int(held_out) && scenes[i]) others.push_back(scenes[i]);
    others.insert(others.end(), additional.begin(), additional.end());
    models[held_out] = learn(pipeline, others);
  });
  return models;
}

void count_pairs(const Pipeline& pipeline, const LearningScene& scene, const Models& models,
                 LevelDecisions& decisions) {
  count(labelled_pairs(scene.percept.structural, scene.objects), models.structural, decisions.structural);
  if (models.assembly)
    count(assembly_pairs(scene, pipeline.structural_groups(scene.percept, models.structural)), *models.assembly,
          decisions.assembly);
}

}  // namespace gestalt
