// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gestalt/config.h"
#include "gestalt/frame.h"
#include "gestalt/model.h"
#include "gestalt/patch_map.h"
#include "gestalt/relation_table.h"
#include "gestalt/segmentation.h"
#include "gestalt/surface_modelling.h"
#include "gestalt/surface_set.h"

namespace gestalt {

/// Milliseconds of each level for one frame.
struct LevelTimes {
  double signal = 0;
  double primitive = 0;
  double structural = 0;  ///< relations and classification
  double decision = 0;

  double total() const { return signal + primitive + structural + decision; }
};

/// Everything that is computed of a frame before a trained model is needed.
struct Percept {
  PatchMap patches;
  SurfaceSet surfaces;
  RelationTable relations;
  LevelTimes times;
};

/// The segmenter: the components of a config, ready to run. Immutable; every method may be called from many threads at
/// once, and gives the same result for any number of threads.
class GESTALT_EXPORT Pipeline {
 public:
  /// Makes the components; reads no model. Throws ConfigError, PluginError.
  Pipeline(Config config, const Registry& registry);

  const Config& config() const { return config_; }
  const std::vector<std::string>& value_names() const { return value_names_; }
  const Classifier& classifier() const { return *classifier_; }

  /// Reads the config's model. Throws ModelError when the config names none, or it does not fit.
  Model load_model() const;

  /// Signal, primitive and structural level. Throws InputError when a relation needs colour and the frame has none.
  Percept perceive(const Frame& frame) const;

  /// Classification of the pairs and the global decision. model must be for value_names(), as load_model() ensures. The
  /// time spent is added to times.
  Segmentation decide(const Percept& percept, const Model& model, LevelTimes* times = nullptr) const;

 private:
  Config config_;
  std::shared_ptr<const Clusterer> clusterer_;
  std::vector<std::shared_ptr<const Fitter>> fitters_;
  SurfaceModellingParams surface_modelling_;
  std::vector<NamedRelation> relations_;
  std::shared_ptr<const Classifier> classifier_;
  std::shared_ptr<const Solver> solver_;
  std::vector<std::string> value_names_;
};

}  // namespace gestalt
