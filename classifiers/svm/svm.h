// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/classifier.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// C-SVC with the kernel exp(-gamma |x - y|^2) (paper, Eq. 10, where the square is lost in print) by libsvm. The
/// probability is libsvm's: a sigmoid of the decision value, fitted on the decision values of five-fold
/// cross-validation (Platt; Lin, Lin and Weng 2007), coupled as by Wu, Lin and Weng (2004).
class Svm final : public Classifier {
 public:
  struct Params {
    double cost = 1;             ///< C
    double gamma = 0;            ///< 0: one over the number of values
    bool class_weights = false;  ///< scale C of a class by n / (2 n_class), so that both weigh the same
    double eps = 0.001;          ///< stopping tolerance of the optimiser
    int seed = 1;                ///< of the split into folds
  };
  static const Parameters<Params>& parameters();

  explicit Svm(const Params& params) : params_(params) {}

  /// The result is the same for equal samples and seed, whatever other threads train or draw meanwhile.
  std::unique_ptr<Predictor> train(const Samples& samples) const override;
  std::unique_ptr<Predictor> restore(const nlohmann::json& state, std::size_t columns) const override;

 private:
  Params params_;
};

}  // namespace gestalt
