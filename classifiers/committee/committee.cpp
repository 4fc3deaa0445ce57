// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "committee.h"

#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "random_forest.h"
#include "svm.h"

namespace gestalt {

namespace {

constexpr const char* share_key = "svm_share";
constexpr const char* svm_key = "svm";
constexpr const char* forest_key = "random_forest";

class CommitteePredictor final : public Predictor {
 public:
  CommitteePredictor(double svm_share, std::unique_ptr<Predictor> svm, std::unique_ptr<Predictor> forest)
      : svm_share_(svm_share), svm_(std::move(svm)), forest_(std::move(forest)) {}

  double probability(std::span<const double> values) const override {
    return svm_share_ * svm_->probability(values) + (1 - svm_share_) * forest_->probability(values);
  }

  nlohmann::json state() const override {
    return {{share_key, svm_share_}, {svm_key, svm_->state()}, {forest_key, forest_->state()}};
  }

 private:
  double svm_share_;
  std::unique_ptr<Predictor> svm_;
  std::unique_ptr<Predictor> forest_;
};

}  // namespace

const Parameters<Committee::Params>& Committee::parameters() {
  static const auto p =
      Parameters<Params>()
          .real("svm_share", &Params::svm_share, 0, 1, "", "weight of the SVM in the mean")
          .real("cost", &Params::cost, 1e-6, 1e6, "", "C of the SVM")
          .real("gamma", &Params::gamma, 0, 1e6, "", "of the SVM's kernel; 0: 1 / number of values")
          .boolean("class_weights", &Params::class_weights,
                   "the SVM weighs each class inversely to its number of pairs")
          .integer("trees", &Params::trees, 1, 2000, "", "number of the forest's trees")
          .integer("depth", &Params::depth, 1, 25, "", "largest depth of a tree")
          .integer("minimum_samples", &Params::minimum_samples, 2, 10000, "pairs", "a smaller node is not split")
          .integer("seed", &Params::seed, 0, std::numeric_limits<int>::max(), "", "of both");
  return p;
}

std::unique_ptr<Predictor> Committee::train(const Samples& samples) const {
  const Svm svm(
      {.cost = params_.cost, .gamma = params_.gamma, .class_weights = params_.class_weights, .seed = params_.seed});
  const RandomForest forest({.trees = params_.trees,
                             .depth = params_.depth,
                             .minimum_samples = params_.minimum_samples,
                             .seed = params_.seed});
  return std::make_unique<CommitteePredictor>(params_.svm_share, svm.train(samples), forest.train(samples));
}

std::unique_ptr<Predictor> Committee::restore(const nlohmann::json& state, std::size_t columns) const {
  if (!state.is_object() || !state.contains(share_key) || !state.contains(svm_key) || !state.contains(forest_key))
    throw ModelError("a committee's state has svm_share, svm and random_forest; this one has not; retrain the model");
  const nlohmann::json& share = state.at(share_key);
  if (!share.is_number() || !(share.get<double>() >= 0 && share.get<double>() <= 1))
    throw ModelError("svm_share must be a number in [0, 1]; retrain the model");
  return std::make_unique<CommitteePredictor>(share.get<double>(), Svm({}).restore(state.at(svm_key), columns),
                                              RandomForest({}).restore(state.at(forest_key), columns));
}

}  // namespace gestalt
