// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nlohmann/json.hpp>
#include <random>

#include "gestalt/core/base/error.h"
#include "subjects.h"

namespace gestalt::conformance {
namespace {

using nlohmann::json;

/// Rows in [-1, 1]^3; positive ones have the larger first value, with a gap between the classes.
Samples separable(int count) {
  std::mt19937 random(5);
  const auto number = [&] { return double(random()) / double(std::mt19937::max()); };
  Samples samples{3, {}, {}};
  for (int i = 0; i < count; ++i) {
    const bool positive = i % 3 != 0;
    samples.values.insert(samples.values.end(),
                          {(positive ? 0.2 : -1) + 0.8 * number(), 2 * number() - 1, 2 * number() - 1});
    samples.positive.push_back(positive);
  }
  return samples;
}

std::vector<double> probabilities(const Predictor& predictor, const Samples& samples) {
  std::vector<double> p;
  for (std::size_t i = 0; i < samples.rows(); ++i) p.push_back(predictor.probability(samples.row(i)));
  return p;
}

/// Every place in a document, as JSON pointers; of a list only its first and last entry.
std::vector<json::json_pointer> places(const json& document, const json::json_pointer& here = json::json_pointer()) {
  std::vector<json::json_pointer> all{here};
  const auto append = [&](const json& inner, const json::json_pointer& place) {
    const auto found = places(inner, place);
    all.insert(all.end(), found.begin(), found.end());
  };
  if (document.is_object())
    for (const auto& [key, value] : document.items()) append(value, here / key);
  if (document.is_array() && !document.empty()) {
    append(document.front(), here / std::size_t{0});
    if (document.size() > 1) append(document.back(), here / (document.size() - 1));
  }
  return all;
}

class ClassifierContract : public SubjectTest<Classifier> {
 protected:
  void expect_refused(const json& state, const std::string& what) const {
    try {
      subject_->restore(state, samples_.columns);
      ADD_FAILURE() << what << " was accepted";
    } catch (const ModelError&) {
    }
  }

  const Samples samples_ = separable(150);
};

TEST_P(ClassifierContract, LearnsASeparableSet) {
  const auto predictor = subject_->train(samples_);
  const std::vector<double> p = probabilities(*predictor, samples_);
  int right = 0;
  for (std::size_t i = 0; i < p.size(); ++i) {
    EXPECT_TRUE(p[i] >= 0 && p[i] <= 1) << p[i];
    right += (p[i] > 0.5) == bool(samples_.positive[i]);
  }
  EXPECT_GE(right, 145) << "of 150";
}

TEST_P(ClassifierContract, DecidesManyRowsAsItDoesOne) {
  const auto predictor = subject_->train(samples_);
  std::vector<double> together(samples_.rows());
  predictor->probabilities(samples_.values, together);
  EXPECT_EQ(together, probabilities(*predictor, samples_));
}

TEST_P(ClassifierContract, LearnsTheSameTwiceAndForAnyNumberOfThreads) {
  const auto run = [&] { return subject_->train(samples_)->state(); };
  const json one = with_threads(1, run);
  EXPECT_EQ(with_threads(1, run), one);
  EXPECT_EQ(with_threads(8, run), one);
}

TEST_P(ClassifierContract, ARestoredPredictorIsTheTrainedOne) {
  const auto trained = subject_->train(samples_);
  const auto restored = subject_->restore(json::parse(trained->state().dump()), samples_.columns);
  EXPECT_EQ(probabilities(*restored, samples_), probabilities(*trained, samples_));
  EXPECT_EQ(restored->state(), trained->state());
}

TEST_P(ClassifierContract, RefusesOneClassAndNoSample) {
  for (const std::uint8_t only : {0, 1}) {
    Samples one_class = samples_;
    std::fill(one_class.positive.begin(), one_class.positive.end(), only);
    EXPECT_THROW(subject_->train(one_class), ModelError);
  }
  EXPECT_THROW(subject_->train({3, {}, {}}), ModelError);
}

TEST_P(ClassifierContract, LearnsFromTheFewestSamples) {
  const auto predictor = subject_->train({1, {-1, 1}, {0, 1}});
  const double p = predictor->probability(std::vector{1.0});
  EXPECT_TRUE(p >= 0 && p <= 1) << p;
}

TEST_P(ClassifierContract, RefusesAStateOfAnotherType) {
  for (const json& state : {json(), json(1), json("state"), json::array(), json::object()})
    expect_refused(state, state.dump());
}

TEST_P(ClassifierContract, RefusesAStateWithAPartMissing) {
  const json state = subject_->train(samples_)->state();
  ASSERT_TRUE(state.is_object());
  for (const auto& [key, value] : state.items()) {
    json damaged = state;
    damaged.erase(key);
    expect_refused(damaged, "a state without '" + key + "'");
  }
}

TEST_P(ClassifierContract, RefusesAStateWithAPartOfAnotherType) {
  const json state = subject_->train(samples_)->state();
  for (const auto& place : places(state)) {
    json damaged = state;
    for (const json& wrong : {json(), json("x"), json::array({json::object()})}) {
      damaged[place] = wrong;
      expect_refused(damaged, place.to_string() + " = " + wrong.dump());
    }
  }
}

// Such a state may still be a possible one; then it must work.
TEST_P(ClassifierContract, RefusesOrSurvivesAnyNumberInAState) {
  const json state = subject_->train(samples_)->state();
  for (const auto& place : places(state)) {
    if (!state[place].is_number()) continue;
    for (const json& number : {json(-1), json(0), json(1000000000), json(-1e300), json(1e300), json(1u << 31)}) {
      json changed = state;
      changed[place] = number;
      try {
        for (const double p : probabilities(*subject_->restore(changed, samples_.columns), samples_))
          ASSERT_TRUE(p >= 0 && p <= 1) << place.to_string() << " = " << number << " gives p = " << p;
      } catch (const ModelError&) {
      }
    }
  }
}

GESTALT_CONFORMANCE(ClassifierContract, "classifier");

}  // namespace
}  // namespace gestalt::conformance
