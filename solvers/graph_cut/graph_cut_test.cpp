// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "graph_cut.h"

#include <gtest/gtest.h>

namespace gestalt {
namespace {

using Groups = std::vector<int>;

Edge edge(int a, int b, double p) { return {a, b, p, Level::structural}; }

const GraphCut::Params as_published{.average_joined = false};

TEST(GraphCut, JoinsSinglePatchesUpToTheWeightK) {
  EXPECT_EQ(GraphCut({}).solve({{9, 9}, {edge(0, 1, 0.5)}}), (Groups{0, 0}));
  EXPECT_EQ(GraphCut({}).solve({{9, 9}, {edge(0, 1, 0.49)}}), (Groups{0, 1}));
  EXPECT_EQ(GraphCut({.k = 0.6}).solve({{9, 9}, {edge(0, 1, 0.45)}}), (Groups{0, 0}));
}

// 0 and 1 join at weight 0.125. Then Int + k / 2 = 0.375 is what an edge to them may weigh.
TEST(GraphCut, AsksMoreOfAnEdgeToALargerComponent) {
  EXPECT_EQ(GraphCut({}).solve({{9, 9, 9}, {edge(0, 1, 0.875), edge(1, 2, 0.625)}}), (Groups{0, 0, 0}));
  EXPECT_EQ(GraphCut({}).solve({{9, 9, 9}, {edge(0, 1, 0.875), edge(1, 2, 0.6)}}), (Groups{0, 0, 1}));
}

TEST(GraphCut, CanCountSizeInPixels) {
  const Graph graph{{10, 1000}, {edge(0, 1, 0.75)}};
  EXPECT_EQ(GraphCut({.k = 5, .size = "pixels"}).solve(graph), (Groups{0, 1}));    // 5 / 1000 < 0.25
  EXPECT_EQ(GraphCut({.k = 250, .size = "pixels"}).solve(graph), (Groups{0, 0}));  // 250 / 1000 = 0.25
}

// 0-1 join first. 0-2 weighs 0.25, 1-2 weighs 0.875; an edge to {0, 1} may weigh 0.375.
class GraphCutAveraging : public testing::Test {
 protected:
  Graph graph(int size_0, int size_1) const {
    return {{size_0, size_1, 50}, {edge(0, 1, 0.875), edge(0, 2, 0.75), edge(1, 2, 0.125)}};
  }
};

TEST_F(GraphCutAveraging, AsPublishedTheBestEdgeDecides) {
  EXPECT_EQ(GraphCut(as_published).solve(graph(50, 50)), (Groups{0, 0, 0}));
}

TEST_F(GraphCutAveraging, TheMeanOfBothEdgesDecides) {
  EXPECT_EQ(GraphCut({}).solve(graph(50, 50)), (Groups{0, 0, 1}));  // (0.25 + 0.875) / 2 = 0.5625
}

TEST_F(GraphCutAveraging, PixelsWeighTheMean) {
  EXPECT_EQ(GraphCut({}).solve(graph(900, 100)), (Groups{0, 0, 0}));  // 0.9 * 0.25 + 0.1 * 0.875 = 0.3125
  EXPECT_EQ(GraphCut({}).solve(graph(100, 900)), (Groups{0, 0, 1}));
}

TEST_F(GraphCutAveraging, PatchesCanWeighTheMean) {
  EXPECT_EQ(GraphCut({.average_weight = "patches"}).solve(graph(900, 100)), (Groups{0, 0, 1}));
}

// 0-1 and 2-3 join at 0.125 each; then 0.375 is allowed. The four edges between the pairs weigh 0.25, 0.5, 0.5 and
// `last`: the mean of means decides, whatever the order in which they were averaged.
TEST(GraphCut, AveragesOverSeveralJoins) {
  const auto groups = [](double last) {
    return GraphCut({}).solve({{8, 8, 8, 8},
                               {edge(0, 1, 0.875), edge(0, 2, 0.75), edge(0, 3, 0.5), edge(1, 2, 0.5),
                                edge(1, 3, 1 - last), edge(2, 3, 0.875)}});
  };
  EXPECT_EQ(groups(0.25), (Groups{0, 0, 0, 0}));  // mean 0.375
  EXPECT_EQ(groups(0.26), (Groups{0, 0, 1, 1}));
}

TEST(GraphCut, NodesWithoutEdgesStayAlone) {
  for (const bool average : {true, false}) {
    EXPECT_EQ(GraphCut({.average_joined = average}).solve({{5, 5}, {}}), (Groups{0, 1}));
    EXPECT_EQ(GraphCut({.average_joined = average}).solve({}), Groups{});
  }
}

// 0-1 and 1-2 weigh 0.25 each. Whichever comes first joins; the other's mean with 0-2 is then 0.625 and refused.
TEST(GraphCut, BreaksTiesByNodeNumber) {
  const std::vector<Edge> edges{edge(0, 1, 0.75), edge(0, 2, 0), edge(1, 2, 0.75)};
  EXPECT_EQ(GraphCut({}).solve({{9, 9, 9}, edges}), (Groups{0, 0, 1}));
}

}  // namespace
}  // namespace gestalt
