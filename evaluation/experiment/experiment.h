// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <exception>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/core/base/output_file.h"
#include "gestalt/core/config/config.h"
#include "gestalt/core/plugin/registry.h"
#include "gestalt/evaluation/score/cross_validation.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// Training and evaluating many configs on the same scenes. What the levels below the classifiers give is computed once
// for a scene and shared by all variants that agree on it; finished variants are kept in files and not computed again.

/// A config to train and evaluate.
struct Variant {
  std::string name;
  Config config;
};

/// Scenes with ground truth that are evaluated beside those of the protocol, by the model of all scenes to learn from.
struct FurtherSet {
  std::string name;
  std::vector<std::filesystem::path> scenes;
};

/// What variants are trained and evaluated on.
struct Protocol {
  std::vector<std::filesystem::path> learn;  ///< scenes with ground truth
  std::vector<std::filesystem::path> test;   ///< empty: cross-validation over learn
  int folds = 5;                             ///< of the cross-validation, >= 2
  std::uint64_t seed = 0;                    ///< see deal_folds()
  std::vector<FurtherSet> further;           ///< of different names
  ReadOptions read;                          ///< of all scenes
};

/// Scores of one category of the scenes that were evaluated; overlap and boundary under the rule table
/// (docs/evaluation.md), all fractions.
struct CategoryScore {
  std::string category;  ///< "all" for the last row, which holds every scene
  std::int64_t images = 0;
  std::int64_t objects = 0;
  double precision = 0;
  double recall = 0;
  double overlap_f = 0;
  double boundary_f = 0;
  double detected = 0;  ///< share of objects with overlap F > 0.75
};

/// The rows of scored images, as summarise() in evaluation.h makes them.
std::vector<CategoryScore> category_scores(const std::vector<ImageScore>& scores,
                                           const std::vector<std::string>& categories);

/// One object of the scenes that were evaluated (paper, Fig. 5).
struct ObjectScore {
  std::string scene;
  std::string category;
  double precision = 0;
  double recall = 0;
};

/// A relation value and its F-score on the training pairs (paper, Eq. 12); may not be finite.
struct ValueScore {
  std::string name;
  double f_score = 0;
};

/// What there is in the scenes of a category (paper, Table 1). Pairs of the assembly level are those that
/// assembly_rows() gives. `same` are the pairs of patches of one object.
struct CategoryCount {
  std::string category;  ///< "all" for the last row
  std::int64_t images = 0;
  std::int64_t objects = 0;
  std::int64_t structural_pairs = 0;
  std::int64_t structural_same = 0;
  std::int64_t assembly_pairs = 0;
  std::int64_t assembly_same = 0;
};

/// Decisions on the labelled pairs of evaluated scenes.
struct PairErrors {
  std::int64_t positive = 0;  ///< pairs
  std::int64_t negative = 0;
  double balanced_error = 0;  ///< Eq. 13 as corrected; not a number without pairs of both kinds
};

struct ExperimentResult {
  std::vector<CategoryScore> scores;
  PairErrors structural;
  PairErrors assembly;
  std::vector<ValueScore> structural_values;
  std::vector<ValueScore> assembly_values;
  std::vector<ObjectScore> objects;
  std::vector<CategoryCount> learn;
  std::vector<CategoryCount> test;     ///< empty in cross-validation
  std::vector<CategoryScore> further;  ///< a row for each further set; counts in nothing else

  const CategoryScore& all() const { return scores.back(); }
};

/// Every number by its member's name.
nlohmann::ordered_json to_json(const std::vector<CategoryScore>& scores);

/// Every number of the result by its member's name; one that is not finite as "nan", "inf" or "-inf".
nlohmann::ordered_json to_json(const ExperimentResult& result);

/// What a run tells while it goes; both may be empty. Called from one thread at a time.
struct ExperimentEvents {
  /// A variant is finished, or was found to be: done of total.
  std::function<void(std::size_t done, std::size_t total, const std::string& variant)> progress;
  std::function<void(const std::string& message)> warning;
};

/// A variant's outcome: a result or why there is none.
struct ExperimentOutcome {
  std::optional<ExperimentResult> result;
  std::exception_ptr failure;
};

/// Outcomes of the variants, in their order. Results are kept as store/<hash>.json, each written when its variant is
/// finished; the hash is of all that matters: the resolved config, the contents of the scenes and how they are used,
/// the programs. Those that are there are taken; a damaged one is computed again after a warning. A variant that cannot
/// be trained has a failure and does not stop the others. The results do not depend on the number of threads, nor on
/// the other variants. Throws InputError when a scene cannot be used, ConfigError for folds that cannot be dealt,
/// OutputError.
std::vector<ExperimentOutcome> run_experiments(const std::vector<Variant>& variants, const Registry& registry,
                                               const Protocol& protocol, const OutputPath& store,
                                               const ExperimentEvents& events = {});

}  // namespace gestalt
