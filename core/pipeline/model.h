// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/scene/graph.h"

namespace gestalt {

/// Linear map of each value's range in the training set to [-1, 1]; values outside are clamped.
/// A value that was constant in training maps to 0.
struct GESTALT_EXPORT Scaling {
  std::vector<double> low;
  std::vector<double> high;

  static Scaling of(const Samples& raw);
  void apply(std::span<const double> values, std::span<double> scaled) const;
};

/// What a model was trained on, for its card and for error messages.
struct TrainingData {
  std::vector<std::string> scenes;
  std::size_t positive_pairs = 0;
  std::size_t negative_pairs = 0;
};

/// A trained classifier of one level with all that is needed to judge a pair.
struct GESTALT_EXPORT Model {
  std::vector<std::string> names;  ///< relation values in order
  Scaling scaling;
  std::string classifier;  ///< plugin that made it
  std::string config_hash;
  TrainingData training;
  std::shared_ptr<const Predictor> predictor;

  /// p(same | r) for raw relation values in the order of names.
  double probability(std::span<const double> values) const;

  /// p(same | r) of many rows that follow each other in values.
  std::vector<double> probabilities(std::span<const double> values) const;
};

/// Scales the samples, trains, and bundles the result. samples hold raw values; training names their scenes, the pairs
/// are counted here.
GESTALT_EXPORT Model train_model(const Classifier& classifier, std::string classifier_name,
                                 std::vector<std::string> names, const Samples& samples, TrainingData training,
                                 std::string config_hash);

/// The models of a config's levels: a model file.
struct Models {
  Model structural;
  std::optional<Model> assembly;  ///< absent when only the structural level was trained
};

/// Writes JSON under a temporary name, then renames. Throws OutputError.
GESTALT_EXPORT void write_models(const std::filesystem::path& file, const Models& models);

/// What a config expects of the model of a level.
struct ExpectedModel {
  const Classifier& classifier;
  std::string classifier_name;     ///< plugin
  std::vector<std::string> names;  ///< relation values in order
};

/// Reads the models for a config; the assembly level only when it is expected. Throws ModelError, naming the file and
/// the remedy, when the file is not a model, lacks a level, was made by another classifier plugin, or has other
/// relation values (the difference is named).
GESTALT_EXPORT Models read_models(const std::filesystem::path& file, const ExpectedModel& structural,
                                  const std::optional<ExpectedModel>& assembly);

}  // namespace gestalt
