// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// Random forest (Breiman 2001), grown by OpenCV. The trees regress the class: a leaf holds the share of positive
/// samples that fell into it, and the probability is the mean of the leaves, finer than a count of votes. OpenCV only
/// grows the trees; they are stored and walked here, since its own reader trusts the file it reads.
class RandomForest final : public Classifier {
 public:
  struct Params {
    int trees = 200;
    int depth = 10;           ///< of a tree at most
    int minimum_samples = 5;  ///< a node with fewer samples is not split
    int variables = 0;        ///< tried at each split; 0: square root of their number
    int seed = 1;
  };
  static const Parameters<Params>& parameters();

  explicit RandomForest(const Params& params) : params_(params) {}
  std::unique_ptr<Predictor> train(const Samples& samples) const override;
  std::unique_ptr<Predictor> restore(const nlohmann::json& state, std::size_t columns) const override;

 private:
  Params params_;
};

}  // namespace gestalt
