// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contributions.h"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace gestalt {
namespace {

/// p = 1/2 + (x + x y) / 4 of the first two scaled values; the third counts for nothing.
class Product final : public Predictor {
 public:
  double probability(std::span<const double> v) const override { return 0.5 + (v[0] + v[0] * v[1]) / 4; }
  nlohmann::json state() const override { return {}; }
};

Model model(std::vector<double> low, std::vector<double> high) {
  Model model;
  model.names = {"r_x", "r_y", "r_z"};
  model.scaling = {std::move(low), std::move(high)};
  model.predictor = std::make_shared<Product>();
  return model;
}

TEST(Contributions, AreThePLessTheMeanOverTheRange) {
  // In units of the range x = 0.5 and y = -1: over the range of x the mean of x is 0, over that of y that of y.
  const std::vector<double> parts = contributions(model({0, 0, 0}, {4, 2, 1}), std::vector{3.0, 0.0, 0.3});
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0], (0.5 + 0.5 * -1) / 4, 1e-12);
  EXPECT_NEAR(parts[1], 0.5 * -1 / 4, 1e-12);
  EXPECT_EQ(parts[2], 0);
}

TEST(Contributions, AValueOutsideTheRangeCountsAsItsEnd) {
  const Model m = model({0, 0, 0}, {4, 2, 1});
  EXPECT_EQ(contributions(m, std::vector{9.0, 1.0, 0.0}), contributions(m, std::vector{4.0, 1.0, 0.0}));
  EXPECT_NEAR(contributions(m, std::vector{9.0, 1.0, 0.0})[0], 0.25, 1e-12);
}

TEST(Contributions, AConstantOfTrainingContributesNothing) {
  EXPECT_EQ(contributions(model({2, 0, 0}, {2, 2, 1}), std::vector{3.0, 1.0, 0.5})[0], 0);
}

}  // namespace
}  // namespace gestalt
