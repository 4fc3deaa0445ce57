#include "my_component.h"

#include <gtest/gtest.h>

namespace {

using Groups = std::vector<int>;

gestalt::Edge edge(int a, int b, double p) { return {a, b, p, gestalt::Level::structural}; }

TEST(MyComponent, JoinsProbableEdges) {
  EXPECT_EQ(MyComponent({}).solve({{9, 9, 9}, {edge(0, 1, 0.4), edge(0, 2, 0.6)}}), (Groups{0, 1, 0}));
}

TEST(MyComponent, TheMoreProbableEdgeWinsWhereOneSpeaksAgainst) {
  const gestalt::Graph graph{{9, 9, 9}, {edge(0, 1, 0.8), edge(0, 2, 0.05), edge(1, 2, 0.9)}};
  EXPECT_EQ(MyComponent({}).solve(graph), (Groups{0, 1, 1}));
  EXPECT_EQ(MyComponent({.veto = 0}).solve(graph), (Groups{0, 0, 0}));
}

}  // namespace
