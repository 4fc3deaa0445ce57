// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gestalt/core/plugin/classifier.h>
#include <gestalt/core/plugin/parameters.h>

/// p(same) = 1 / (1 + exp(-(w . r + b))): the log odds are a sum over the relation values, so that the model file can
/// be read by eye. Regularised by |w|^2 and trained to the optimum by Newton's method.
class LogisticRegression final : public gestalt::Classifier {
 public:
  struct Params {
    double penalty = 1;   ///< of |w|^2 / 2, beside the sum over the pairs
    bool squares = true;  ///< whether the squares of the values are values, too
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit LogisticRegression(const Params& params) : params_(params) {}
  std::unique_ptr<gestalt::Predictor> train(const gestalt::Samples& samples) const override;
  std::unique_ptr<gestalt::Predictor> restore(const nlohmann::json& state, std::size_t columns) const override;

 private:
  Params params_;
};
