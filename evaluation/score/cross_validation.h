// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/evaluation.h"

namespace gestalt {

/// Models of each fold, trained on the scenes of all other folds and on the additional ones, in parallel. A scene that
/// is null is left out.
/// fold: of each scene, in [0, folds). Throws ModelError when a fold's training pairs are of one class.
GESTALT_EXPORT std::vector<Models> learn_folds(const Pipeline& pipeline,
                                               const std::vector<const LearningScene*>& scenes,
                                               const std::vector<int>& fold, int folds,
                                               const std::vector<const LearningScene*>& additional = {});

/// How the classifier of each level decides the labelled pairs of scenes.
struct LevelDecisions {
  PairDecisions structural;
  PairDecisions assembly;  ///< empty without the assembly level
};

/// Adds the decisions on the pairs of a scene that the models were not trained on.
GESTALT_EXPORT void count_pairs(const Pipeline& pipeline, const LearningScene& scene, const Models& models,
                                LevelDecisions& decisions);

}  // namespace gestalt
