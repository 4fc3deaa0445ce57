// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <libsvm/svm.h>

#include <array>
#include <vector>

#include "gestalt/core/plugin/classifier.h"

namespace gestalt {

/// A trained support vector machine in plain numbers. Class i of two is labels[i]; its support vectors are counts[i]
/// consecutive rows.
struct SvmState {
  double gamma;
  double rho;     ///< the decision value is the kernel sum minus rho
  double prob_a;  ///< p(class 0) = 1 / (1 + exp(prob_a * decision + prob_b))
  double prob_b;
  std::array<int, 2> labels;  ///< 1 same object, 0 not
  std::array<int, 2> counts;
  std::vector<double> coefficients;     ///< one for each support vector
  std::vector<double> support_vectors;  ///< row-major, columns values each
};

/// Throws ModelError unless the state is complete and consistent.
SvmState read_svm_state(const nlohmann::json& state, std::size_t columns);

/// A trained and a restored machine are both made of an SvmState, so they give equal probabilities to the last bit.
class SvmPredictor final : public Predictor {
 public:
  SvmPredictor(SvmState state, std::size_t columns);
  SvmPredictor(const SvmPredictor&) = delete;
  SvmPredictor& operator=(const SvmPredictor&) = delete;

  double probability(std::span<const double> values) const override;
  nlohmann::json state() const override;

 private:
  SvmState state_;
  std::vector<svm_node> nodes_;     // the support vectors as libsvm wants them
  std::vector<svm_node*> vectors_;  // begin of each in nodes_
  double* coefficients_;
  svm_model model_{};  // points into the members above
};

/// Values as libsvm's (index, value) pairs with the end mark.
void append_nodes(std::span<const double> values, std::vector<svm_node>& nodes);

}  // namespace gestalt
