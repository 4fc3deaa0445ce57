// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "logistic_regression.h"

#include <gtest/gtest.h>

#include <gestalt/core/base/error.h>
#include <cmath>
#include <nlohmann/json.hpp>

namespace {

/// One value in [-1, 1], of which the probability is that of the log odds slope x + shift; each pair many times.
gestalt::Samples samples(double slope, double shift) {
  gestalt::Samples samples;
  samples.columns = 1;
  for (int i = -10; i <= 10; ++i) {
    const double x = i / 10.0;
    const int positive = int(std::lround(1000 / (1 + std::exp(-(slope * x + shift)))));
    for (int k = 0; k < 1000; ++k) {
      samples.values.push_back(x);
      samples.positive.push_back(k < positive);
    }
  }
  return samples;
}

TEST(LogisticRegression, FindsTheLogOddsThatThePairsHave) {
  const auto predictor = LogisticRegression({.penalty = 1e-6}).train(samples(3, -1));
  for (const double x : {-1.0, 0.0, 0.7}) {
    const double row[] = {x};
    EXPECT_NEAR(predictor->probability(row), 1 / (1 + std::exp(-(3 * x - 1))), 2e-3);
  }
}

TEST(LogisticRegression, APenaltyMakesItLessSure) {
  const double row[] = {1.0};
  EXPECT_LT(LogisticRegression({.penalty = 1e4}).train(samples(3, 0))->probability(row),
            LogisticRegression({}).train(samples(3, 0))->probability(row));
}

TEST(LogisticRegression, RefusesAModelOfOtherValues) {
  const auto state = LogisticRegression({}).train(samples(3, 0))->state();
  EXPECT_THROW(LogisticRegression({}).restore(state, 2), gestalt::ModelError);
  EXPECT_THROW(LogisticRegression({}).restore({{"weights", "none"}}, 1), gestalt::ModelError);
}

}  // namespace
