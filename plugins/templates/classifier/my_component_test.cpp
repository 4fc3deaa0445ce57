#include "my_component.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

/// Two negative pairs around (-1, 0) and two positive ones around (1, 0).
const gestalt::Samples samples{2, {-1, 0.5, -1, -0.5, 1, 0.5, 1, -0.5}, {0, 0, 1, 1}};

double probability(const std::vector<double>& row) { return MyComponent({}).train(samples)->probability(row); }

TEST(MyComponent, IsUndecidedBetweenTheMeans) { EXPECT_NEAR(probability({0, 0.3}), 0.5, 1e-12); }

TEST(MyComponent, GivesTheDeclaredOddsAtTheMeans) {
  EXPECT_NEAR(std::log(probability({1, 0}) / (1 - probability({1, 0}))), 4, 1e-9);
  EXPECT_NEAR(probability({-1, 0}), 1 - probability({1, 0}), 1e-12);
}

TEST(MyComponent, IsUndecidedWhenTheMeansAreEqual) {
  const auto predictor = MyComponent({}).train({1, {0.3, 0.3}, {0, 1}});
  EXPECT_EQ(predictor->probability(std::vector{1.0}), 0.5);
}

}  // namespace
