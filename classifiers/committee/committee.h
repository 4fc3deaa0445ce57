// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// An SVM and a random forest, both trained on all samples; the probability is the mean of theirs. The two err on
/// different pairs: the SVM's smooth border is sure far from what it has seen, the forest is not.
class Committee final : public Classifier {
 public:
  struct Params {
    double svm_share = 0.5;      ///< weight of the SVM in the mean
    double cost = 1;             ///< of the SVM
    double gamma = 0;            ///< of the SVM; 0: one over the number of values
    bool class_weights = false;  ///< of the SVM
    int trees = 200;             ///< of the forest
    int depth = 10;              ///< of the forest
    int minimum_samples = 5;     ///< of the forest
    int seed = 1;                ///< of both
  };
  static const Parameters<Params>& parameters();

  explicit Committee(const Params& params) : params_(params) {}
  std::unique_ptr<Predictor> train(const Samples& samples) const override;
  std::unique_ptr<Predictor> restore(const nlohmann::json& state, std::size_t columns) const override;

 private:
  Params params_;
};

}  // namespace gestalt
