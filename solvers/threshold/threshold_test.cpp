// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "threshold.h"

#include <gtest/gtest.h>

namespace gestalt {
namespace {

using Groups = std::vector<int>;

Edge edge(int a, int b, double p) { return {a, b, p, Level::structural}; }

TEST(Threshold, JoinsEdgesThatReachTheProbability) {
  const Graph graph{{9, 9, 9, 9}, {edge(0, 2, 0.7), edge(1, 3, 0.69)}};
  EXPECT_EQ(Threshold({.probability = 0.7}).solve(graph), (Groups{0, 1, 0, 2}));
}

TEST(Threshold, OneGoodEdgeIsEnoughToJoinTwoGroups) {
  const Graph graph{{9, 9, 9}, {edge(0, 1, 0.9), edge(0, 2, 0.1), edge(1, 2, 0.6)}};
  EXPECT_EQ(Threshold({}).solve(graph), (Groups{0, 0, 0}));
}

TEST(Threshold, NodesWithoutEdgesStayAlone) {
  EXPECT_EQ(Threshold({}).solve({{5, 5}, {}}), (Groups{0, 1}));
  EXPECT_EQ(Threshold({}).solve({}), Groups{});
}

}  // namespace
}  // namespace gestalt
