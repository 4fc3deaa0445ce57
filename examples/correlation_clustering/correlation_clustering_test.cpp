// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "correlation_clustering.h"

#include <gtest/gtest.h>

namespace {

using Groups = std::vector<int>;

gestalt::Edge edge(int a, int b, double p, gestalt::Level level = gestalt::Level::structural) {
  return {a, b, p, level};
}

TEST(CorrelationClustering, EdgesWithinAGroupThatSpeakAgainstItCount) {
  // 0 - 1 and 1 - 2 are likely, but 0 - 2 is surely two objects: connected components would join all three.
  const gestalt::Graph graph{{9, 9, 9}, {edge(0, 1, 0.9), edge(0, 2, 0.001), edge(1, 2, 0.8)}};
  EXPECT_EQ(CorrelationClustering({}).solve(graph), (Groups{0, 0, 1}));
}

TEST(CorrelationClustering, ManyWeakEdgesOutweighOneThatIsWrong) {
  const gestalt::Graph graph{{9, 9, 9}, {edge(0, 1, 0.95), edge(0, 2, 0.6), edge(1, 2, 0.9)}};
  EXPECT_EQ(CorrelationClustering({}).solve(graph), (Groups{0, 0, 0}));
}

TEST(CorrelationClustering, APatchMovesWhereItBelongsBetter) {
  // Greedily 1 goes to 0; once 2, 3 and 4 are one, their edges together pull it over.
  const gestalt::Graph graph{{9, 9, 9, 9, 9},
                             {edge(0, 1, 0.9), edge(0, 2, 0.05), edge(1, 2, 0.8), edge(1, 3, 0.8), edge(1, 4, 0.8),
                              edge(2, 3, 0.85), edge(2, 4, 0.85), edge(3, 4, 0.85)}};
  const Groups groups = CorrelationClustering({.probability = 0.5}).solve(graph);
  EXPECT_EQ(groups[1], groups[2]);
  EXPECT_EQ(groups[2], groups[4]);
  EXPECT_NE(groups[0], groups[2]);
}

TEST(CorrelationClustering, EdgesOfTheAssemblyLevelMayWeighLess) {
  const gestalt::Graph graph{{9, 9, 9}, {edge(0, 1, 0.8), edge(0, 2, 0.1, gestalt::Level::assembly), edge(1, 2, 0.7)}};
  EXPECT_EQ(CorrelationClustering({.probability = 0.5}).solve(graph), (Groups{0, 0, 1}));
  EXPECT_EQ(CorrelationClustering({.probability = 0.5, .assembly_weight = 0.2}).solve(graph), (Groups{0, 0, 0}));
}

}  // namespace
