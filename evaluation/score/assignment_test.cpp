// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/score/assignment.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>
#include <random>

namespace gestalt {
namespace {

using Pairs = std::vector<std::pair<int, int>>;

Pairs assign(const Eigen::MatrixXd& weights) {
  Pairs pairs;
  for (const auto& [row, column] : largest_assignment(weights)) pairs.emplace_back(row, column);
  return pairs;
}

TEST(LargestAssignment, PrefersTheBestTotalToTheBestPair) {
  // The largest entry, 9, leaves 1 for the other row: 10. The others give 8 + 7.
  EXPECT_EQ(assign(Eigen::MatrixXd{{9, 8}, {7, 1}}), (Pairs{{0, 1}, {1, 0}}));
}

TEST(LargestAssignment, LeavesRowsOrColumnsOver) {
  const Eigen::MatrixXd tall{{0.2, 0.1}, {0.9, 0.8}, {0.7, 0.1}};  // 0.8 + 0.7
  EXPECT_EQ(assign(tall), (Pairs{{1, 1}, {2, 0}}));
  EXPECT_EQ(assign(tall.transpose()), (Pairs{{0, 2}, {1, 1}}));
}

TEST(LargestAssignment, OfNothingIsNothing) {
  EXPECT_TRUE(assign(Eigen::MatrixXd(0, 3)).empty());
  EXPECT_TRUE(assign(Eigen::MatrixXd(3, 0)).empty());
}

// Values that scipy 1.10 gives.
TEST(LargestAssignment, BreaksTiesAsScipyDoes) {
  EXPECT_EQ(assign(Eigen::MatrixXd::Zero(3, 3)), (Pairs{{0, 0}, {1, 1}, {2, 2}}));
  EXPECT_EQ(assign(Eigen::MatrixXd{{0, 0, 0, 0.5}, {0, 0, 0, 0}, {0, 0.5, 0, 0.5}}), (Pairs{{0, 3}, {1, 0}, {2, 1}}));
  EXPECT_EQ(assign(Eigen::MatrixXd{{1, 1, 0}, {1, 1, 0}, {1, 1, 0}, {0, 0, 0}}), (Pairs{{0, 0}, {1, 1}, {2, 2}}));
}

TEST(LargestAssignment, IsAsGoodAsTheBestOfAllPermutations) {
  std::mt19937 random(7);
  for (int trial = 0; trial < 200; ++trial) {
    const int rows = 1 + int(random() % 5), columns = rows + int(random() % 3);
    Eigen::MatrixXd weights(rows, columns);
    for (double& weight : weights.reshaped()) weight = double(random() % 7) / 7;
    std::vector<int> order(static_cast<std::size_t>(columns));
    std::iota(order.begin(), order.end(), 0);
    double best = 0;
    do {
      double total = 0;
      for (int i = 0; i < rows; ++i) total += weights(i, order[std::size_t(i)]);
      best = std::max(best, total);
    } while (std::next_permutation(order.begin(), order.end()));

    double total = 0;
    std::vector<int> used(static_cast<std::size_t>(columns), 0);
    for (const auto& [row, column] : assign(weights)) {
      total += weights(row, column);
      EXPECT_EQ(++used[std::size_t(column)], 1);
    }
    EXPECT_EQ(std::accumulate(used.begin(), used.end(), 0), rows);
    EXPECT_NEAR(total, best, 1e-12);
  }
}

}  // namespace
}  // namespace gestalt
