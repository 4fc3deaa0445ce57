// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "svm_predictor.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/model_fields.h"

namespace gestalt {

using nlohmann::json;

namespace {

std::array<int, 2> pair_field(const json& state, const std::string& key, int high) {
  const std::vector<int> values = integers_field(state, key, 0, high);
  if (values.size() != 2) throw ModelError("'" + key + "' must have two entries");
  return {values[0], values[1]};
}

}  // namespace

SvmState read_svm_state(const json& state, std::size_t columns) {
  SvmState s{number_field(state, "gamma"),         number_field(state, "rho"),
             number_field(state, "prob_a"),        number_field(state, "prob_b"),
             pair_field(state, "labels", 1),       pair_field(state, "counts", std::numeric_limits<int>::max()),
             numbers_field(state, "coefficients"), numbers_field(state, "support_vectors")};
  if (s.gamma < 0) throw ModelError("'gamma' must not be negative");
  if (s.labels[0] == s.labels[1]) throw ModelError("'labels' must be two different ones");
  if (s.coefficients.empty() || std::size_t(s.counts[0]) + std::size_t(s.counts[1]) != s.coefficients.size())
    throw ModelError("'coefficients' must have as many entries as 'counts' add up to");
  if (s.support_vectors.size() != s.coefficients.size() * columns)
    throw ModelError("'support_vectors' must have " + std::to_string(columns) + " values for each coefficient");
  return s;
}

void append_nodes(std::span<const double> values, std::vector<svm_node>& nodes) {
  int index = 0;
  for (const double value : values) nodes.push_back({++index, value});
  nodes.push_back({-1, 0});
}

SvmPredictor::SvmPredictor(SvmState state, std::size_t columns) : state_(std::move(state)) {
  const std::size_t count = state_.coefficients.size();
  nodes_.reserve(count * (columns + 1));
  for (std::size_t i = 0; i < count; ++i) append_nodes({state_.support_vectors.data() + i * columns, columns}, nodes_);
  for (std::size_t i = 0; i < count; ++i) vectors_.push_back(nodes_.data() + i * (columns + 1));
  coefficients_ = state_.coefficients.data();

  model_.param.svm_type = C_SVC;
  model_.param.kernel_type = RBF;
  model_.param.gamma = state_.gamma;
  model_.nr_class = 2;
  model_.l = int(count);
  model_.SV = vectors_.data();
  model_.sv_coef = &coefficients_;
  model_.rho = &state_.rho;
  model_.probA = &state_.prob_a;
  model_.probB = &state_.prob_b;
  model_.label = state_.labels.data();
  model_.nSV = state_.counts.data();
}

double SvmPredictor::probability(std::span<const double> values) const {
  std::vector<svm_node> row;
  row.reserve(values.size() + 1);
  append_nodes(values, row);
  std::array<double, 2> of_class{};
  svm_predict_probability(&model_, row.data(), of_class.data());
  return of_class[state_.labels[0] == 1 ? 0 : 1];
}

json SvmPredictor::state() const {
  return {{"gamma", state_.gamma},
          {"rho", state_.rho},
          {"prob_a", state_.prob_a},
          {"prob_b", state_.prob_b},
          {"labels", state_.labels},
          {"counts", state_.counts},
          {"coefficients", state_.coefficients},
          {"support_vectors", state_.support_vectors}};
}

}  // namespace gestalt
