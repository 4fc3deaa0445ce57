// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/evaluation/experiment/experiment.h"

namespace gestalt {

/// The relations that several variants have at a level, each once, and the columns of their table.
struct SharedRelations {
  struct Column {
    std::size_t component;  ///< index into components
    std::string value;      ///< as the relation declares it
  };
  std::vector<ComponentConfig> components;  ///< with all their values
  std::vector<Column> columns;              ///< of the shared table, in order

  void add(const ComponentConfig& relation, const Registry& registry);

  /// The part of the shared table that a variant with this level has.
  RelationTable select(const RelationTable& shared, const Percept& percept, const LevelConfig& level) const;
};

/// The relations of several variants with equal canonical_surfaces(), as one pipeline that computes each of them once
/// for a scene.
class SharedFeatures {
 public:
  SharedFeatures(const std::vector<const Variant*>& variants, const Registry& registry);

  LearningScene perceive(const Frame& frame, const cv::Mat_<std::uint16_t>& ground_truth) const;

  /// The scene as the variant's own pipeline would perceive it: its relations in its order, the values that it keeps,
  /// the pairs of patches that are large enough for it.
  LearningScene scene_for(const Variant& variant, const LearningScene& shared) const;

 private:
  SharedRelations structural_, assembly_;
  std::unique_ptr<const Pipeline> pipeline_;
};

}  // namespace gestalt
