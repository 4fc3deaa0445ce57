// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/feature_score.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gestalt::test {
namespace {

TEST(FeatureScores, FollowTheEquation) {
  // First column: positive 1, 3 (mean 2, variance 2), negative 5, 6, 10 (mean 7, variance 7), all: mean 5.
  // (9 + 4) / (2 + 7). Second: constant. Third: constant in each class only.
  const Samples samples{3, {1, 4, 0, 5, 4, 1, 3, 4, 0, 6, 4, 1, 10, 4, 1}, {1, 0, 1, 0, 0}};
  const std::vector<double> scores = feature_scores(samples);
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_NEAR(scores[0], 13.0 / 9, 1e-12);
  EXPECT_EQ(scores[1], 0);
  EXPECT_TRUE(std::isinf(scores[2]));
}

TEST(FeatureScores, DoNotDependOnUnitAndOffset) {
  const Samples samples{1, {1, 3, 5, 6, 10}, {1, 1, 0, 0, 0}};
  Samples other = samples;
  for (double& value : other.values) value = 100 - 8 * value;
  EXPECT_NEAR(feature_scores(other)[0], feature_scores(samples)[0], 1e-12);
}

TEST(FeatureScores, NeedTwoSamplesOfEachClass) {
  EXPECT_TRUE(std::isnan(feature_scores({1, {1, 2, 3}, {1, 0, 0}})[0]));
  EXPECT_TRUE(std::isnan(feature_scores({1, {}, {}})[0]));
  EXPECT_TRUE(feature_scores({}).empty());
}

}  // namespace
}  // namespace gestalt::test
