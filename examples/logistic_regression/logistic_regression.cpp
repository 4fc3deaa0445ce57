// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "logistic_regression.h"

#include <Eigen/Cholesky>
#include <cmath>
#include <nlohmann/json.hpp>

#include <gestalt/core/base/error.h>

namespace {

constexpr int most_steps = 50;

double logistic(double x) { return 1 / (1 + std::exp(-x)); }

/// The values of a row, their squares if wanted, and 1 for the constant term.
Eigen::VectorXd features(std::span<const double> row, bool squares) {
  const Eigen::Map<const Eigen::VectorXd> values(row.data(), Eigen::Index(row.size()));
  Eigen::VectorXd all(values.size() * (squares ? 2 : 1) + 1);
  if (squares)
    all << values, values.cwiseAbs2(), 1;
  else
    all << values, 1;
  return all;
}

class LogisticPredictor final : public gestalt::Predictor {
 public:
  LogisticPredictor(Eigen::VectorXd weights, bool squares) : weights_(std::move(weights)), squares_(squares) {}

  double probability(std::span<const double> values) const override {
    return logistic(weights_.dot(features(values, squares_)));
  }
  nlohmann::json state() const override {
    return {{"weights", std::vector<double>(weights_.begin(), weights_.end())}, {"squares", squares_}};
  }

 private:
  Eigen::VectorXd weights_;  // the constant term last
  bool squares_;
};

}  // namespace

const gestalt::Parameters<LogisticRegression::Params>& LogisticRegression::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>()
          .real("penalty", &Params::penalty, 1e-6, 1e6, "", "of large weights; more makes probabilities less sure")
          .boolean("squares", &Params::squares, "the squares of the values are values, too");
  return parameters;
}

std::unique_ptr<gestalt::Predictor> LogisticRegression::train(const gestalt::Samples& samples) const {
  gestalt::require_both_classes(samples);
  const Eigen::Index rows = Eigen::Index(samples.rows());
  const Eigen::Index columns = Eigen::Index(samples.columns) * (params_.squares ? 2 : 1) + 1;
  Eigen::MatrixXd x(rows, columns);
  for (Eigen::Index i = 0; i < rows; ++i)
    x.row(i) =
        features(std::span(samples.values).subspan(std::size_t(i) * samples.columns, samples.columns), params_.squares);
  Eigen::VectorXd penalty = Eigen::VectorXd::Constant(columns, params_.penalty);
  penalty[columns - 1] = 1e-9;  // the constant term is free

  Eigen::VectorXd weights = Eigen::VectorXd::Zero(columns);
  for (int step = 0; step < most_steps; ++step) {
    const Eigen::VectorXd p = (x * weights).unaryExpr(&logistic);
    Eigen::VectorXd error = p;
    for (Eigen::Index i = 0; i < rows; ++i) error[i] -= samples.positive[std::size_t(i)];
    const Eigen::VectorXd gradient = x.transpose() * error + penalty.cwiseProduct(weights);
    const Eigen::VectorXd curvature = (p.array() * (1 - p.array())).matrix();
    Eigen::MatrixXd hessian = x.transpose() * curvature.asDiagonal() * x;
    hessian.diagonal() += penalty;
    Eigen::VectorXd change = hessian.ldlt().solve(gradient);
    const double length = change.norm();
    if (length > 10) change *= 10 / length;  // far from the optimum the parabola is not a guide
    weights -= change;
    if (length < 1e-9) break;
  }
  return std::make_unique<LogisticPredictor>(weights, params_.squares);
}

std::unique_ptr<gestalt::Predictor> LogisticRegression::restore(const nlohmann::json& state,
                                                                std::size_t columns) const {
  try {
    const auto weights = state.at("weights").get<std::vector<double>>();
    const bool squares = state.at("squares").get<bool>();
    if (weights.size() != columns * (squares ? 2 : 1) + 1)
      throw gestalt::ModelError("has " + std::to_string(weights.size()) + " weights for " + std::to_string(columns) +
                                " values; train it again");
    return std::make_unique<LogisticPredictor>(
        Eigen::Map<const Eigen::VectorXd>(weights.data(), Eigen::Index(weights.size())), squares);
  } catch (const nlohmann::json::exception& error) {
    throw gestalt::ModelError(std::string("is damaged (") + error.what() + "); train it again");
  }
}
