// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "svm.h"

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "libsvm_random.h"
#include "svm_predictor.h"

namespace gestalt {

namespace {

/// The samples as libsvm wants them. Rows point into nodes.
struct Problem {
  explicit Problem(const Samples& samples) {
    nodes.reserve(samples.rows() * (samples.columns + 1));
    for (std::size_t i = 0; i < samples.rows(); ++i) append_nodes(samples.row(i), nodes);
    for (std::size_t i = 0; i < samples.rows(); ++i) rows.push_back(nodes.data() + i * (samples.columns + 1));
    labels.assign(samples.positive.begin(), samples.positive.end());
    view = {int(samples.rows()), labels.data(), rows.data()};
  }

  std::vector<svm_node> nodes;
  std::vector<svm_node*> rows;
  std::vector<double> labels;
  svm_problem view{};
};

struct ModelDeleter {
  void operator()(svm_model* model) const { svm_free_and_destroy_model(&model); }
};
using TrainedModel = std::unique_ptr<svm_model, ModelDeleter>;

TrainedModel train_quietly(const Problem& problem, const svm_parameter& parameter, int seed) {
  [[maybe_unused]] static const bool quiet = (svm_set_print_string_function([](const char*) {}), true);
  seed_libsvm(unsigned(seed));
  return TrainedModel(svm_train(&problem.view, &parameter));
}

SvmState state_of(const svm_model& model, std::size_t columns) {
  SvmState state{model.param.gamma,
                 model.rho[0],
                 model.probA[0],
                 model.probB[0],
                 {model.label[0], model.label[1]},
                 {model.nSV[0], model.nSV[1]},
                 {model.sv_coef[0], model.sv_coef[0] + model.l},
                 {}};
  for (int i = 0; i < model.l; ++i)
    for (std::size_t c = 0; c < columns; ++c) state.support_vectors.push_back(model.SV[i][c].value);
  return state;
}

}  // namespace

const Parameters<Svm::Params>& Svm::parameters() {
  static const auto p =
      Parameters<Params>()
          .real("cost", &Params::cost, 1e-6, 1e6, "", "C, the price of a training pair on the wrong side")
          .real("gamma", &Params::gamma, 0, 1e6, "", "of the kernel exp(-gamma |x - y|^2); 0: 1 / number of values")
          .boolean("class_weights", &Params::class_weights, "weigh each class inversely to its number of pairs")
          .real("eps", &Params::eps, 1e-9, 0.1, "", "stopping tolerance of the optimiser")
          .integer("seed", &Params::seed, 0, std::numeric_limits<int>::max(), "",
                   "of the random folds on which the probability is fitted");
  return p;
}

std::unique_ptr<Predictor> Svm::train(const Samples& samples) const {
  require_both_classes(samples);
  const Problem problem(samples);

  const auto count = double(samples.rows());
  const auto positive = double(std::count(samples.positive.begin(), samples.positive.end(), 1));
  std::array<int, 2> weight_labels{0, 1};
  std::array<double, 2> weights{count / (2 * (count - positive)), count / (2 * positive)};

  svm_parameter parameter{};
  parameter.svm_type = C_SVC;
  parameter.kernel_type = RBF;
  parameter.gamma = params_.gamma > 0 ? params_.gamma : 1.0 / double(samples.columns);
  parameter.cache_size = 100;  // MB
  parameter.eps = params_.eps;
  parameter.C = params_.cost;
  parameter.nr_weight = params_.class_weights ? 2 : 0;
  parameter.weight_label = weight_labels.data();
  parameter.weight = weights.data();
  parameter.shrinking = 1;
  parameter.probability = 1;
  if (const char* wrong = svm_check_parameter(&problem.view, &parameter))
    throw ModelError(std::string("libsvm cannot train: ") + wrong);

  const TrainedModel model = train_quietly(problem, parameter, params_.seed);
  return std::make_unique<SvmPredictor>(state_of(*model, samples.columns), samples.columns);
}

std::unique_ptr<Predictor> Svm::restore(const nlohmann::json& state, std::size_t columns) const {
  return std::make_unique<SvmPredictor>(read_svm_state(state, columns), columns);
}

}  // namespace gestalt
