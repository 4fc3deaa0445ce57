// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "group_linkage.h"

#include <gtest/gtest.h>

namespace gestalt {
namespace {

using Groups = std::vector<int>;

Edge structural(int a, int b, double p) { return {a, b, p, Level::structural}; }
Edge assembly(int a, int b, double p) { return {a, b, p, Level::assembly}; }

TEST(GroupLinkage, WithoutTheAssemblyLevelGroupsAreThoseOfGraphCut) {
  EXPECT_EQ(GroupLinkage({}).solve({{9, 9, 9}, {structural(0, 1, 0.5), structural(1, 2, 0.4)}}), (Groups{0, 0, 1}));
}

// Patches 0 and 1 are a group by p = 0.9. Their edges to patch 2 say 0.9 and 0.3.
TEST(GroupLinkage, TheMeanOverAllPixelPairsDecides) {
  const auto groups = [](int size_0, int size_1) {
    return GroupLinkage({}).solve(
        {{size_0, size_1, 50}, {structural(0, 1, 0.9), assembly(0, 2, 0.9), assembly(1, 2, 0.3)}});
  };
  EXPECT_EQ(groups(100, 100), (Groups{0, 0, 1}));  // 0.6
  EXPECT_EQ(groups(300, 100), (Groups{0, 0, 0}));  // 0.75
}

TEST(GroupLinkage, AStructuralEdgeThatWasRefusedSpeaksAgainst) {
  const Edge joins = assembly(0, 2, 0.8);
  EXPECT_EQ(GroupLinkage({}).solve({{50, 50, 50}, {structural(0, 1, 0.9), joins}}), (Groups{0, 0, 0}));
  EXPECT_EQ(GroupLinkage({}).solve({{50, 50, 50}, {structural(0, 1, 0.9), joins, structural(1, 2, 0.1)}}),
            (Groups{0, 0, 1}));
}

TEST(GroupLinkage, AnAssemblyEdgeNeverSplitsAStructuralGroup) {
  EXPECT_EQ(GroupLinkage({}).solve({{50, 50, 50}, {structural(0, 1, 0.9), assembly(0, 2, 0.99), assembly(1, 2, 0)}}),
            (Groups{0, 0, 1}));
}

// 0 and 1 are joined first (0.9); then the mean of 0-2 and 1-2, weighted by the pixels of 0 and 1, counts.
TEST(GroupLinkage, MeansAreAveragedWhenGroupsJoin) {
  const auto groups = [](int size_0, int size_1) {
    return GroupLinkage({}).solve(
        {{size_0, size_1, 70}, {assembly(0, 1, 0.9), assembly(0, 2, 0.8), assembly(1, 2, 0.4)}});
  };
  EXPECT_EQ(groups(100, 100), (Groups{0, 0, 1}));  // 0.6
  EXPECT_EQ(groups(900, 100), (Groups{0, 0, 0}));  // 0.76
}

TEST(GroupLinkage, ProbabilityIsTheLeastThatJoins) {
  const Graph graph{{10, 10}, {assembly(0, 1, 0.625)}};
  EXPECT_EQ(GroupLinkage({.probability = 0.625}).solve(graph), (Groups{0, 0}));
  EXPECT_EQ(GroupLinkage({.probability = 0.626}).solve(graph), (Groups{0, 1}));
}

}  // namespace
}  // namespace gestalt
