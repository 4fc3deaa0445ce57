#include "my_component.h"

#include <gestalt/core/base/error.h>
#include <gestalt/core/pipeline/model_fields.h>

#include <Eigen/Core>
#include <cmath>
#include <nlohmann/json.hpp>

namespace {

class MyComponentPredictor final : public gestalt::Predictor {
 public:
  MyComponentPredictor(std::vector<double> weights, double bias) : weights_(std::move(weights)), bias_(bias) {}

  double probability(std::span<const double> values) const override {
    double log_odds = bias_;
    for (std::size_t i = 0; i < values.size(); ++i) log_odds += weights_[i] * values[i];
    return 1 / (1 + std::exp(-log_odds));
  }

  nlohmann::json state() const override { return {{"weights", weights_}, {"bias", bias_}}; }

 private:
  std::vector<double> weights_;
  double bias_;
};

/// Mean row of the positive or the negative pairs.
Eigen::VectorXd mean(const gestalt::Samples& samples, bool positive) {
  Eigen::VectorXd sum = Eigen::VectorXd::Zero(Eigen::Index(samples.columns));
  int count = 0;
  for (std::size_t i = 0; i < samples.rows(); ++i) {
    if (bool(samples.positive[i]) != positive) continue;
    sum += Eigen::Map<const Eigen::VectorXd>(samples.row(i).data(), sum.size());
    ++count;
  }
  return sum / count;
}

}  // namespace

const gestalt::Parameters<MyComponent::Params>& MyComponent::parameters() {
  static const auto parameters = gestalt::Parameters<Params>().real("sharpness", &Params::sharpness, 0.1, 100, "",
                                                                    "log odds at the mean of the positive pairs");
  return parameters;
}

std::unique_ptr<gestalt::Predictor> MyComponent::train(const gestalt::Samples& samples) const {
  gestalt::require_both_classes(samples);
  const Eigen::VectorXd positive = mean(samples, true), negative = mean(samples, false);
  const Eigen::VectorXd line = positive - negative;
  const double length = line.squaredNorm();
  const Eigen::VectorXd weights = length > 0 ? Eigen::VectorXd(2 * params_.sharpness / length * line) : line;
  return std::make_unique<MyComponentPredictor>(std::vector<double>(weights.begin(), weights.end()),
                                                -weights.dot(positive + negative) / 2);
}

std::unique_ptr<gestalt::Predictor> MyComponent::restore(const nlohmann::json& state, std::size_t columns) const {
  std::vector<double> weights = gestalt::numbers_field(state, "weights");
  if (weights.size() != columns)
    throw gestalt::ModelError("it has " + std::to_string(weights.size()) + " weights for " + std::to_string(columns) +
                              " values; retrain the model");
  return std::make_unique<MyComponentPredictor>(std::move(weights), gestalt::number_field(state, "bias"));
}
