// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <random>

#include "subjects.h"

namespace gestalt::conformance {
namespace {

using Groups = std::vector<int>;

Edge edge(int a, int b, double p) { return {a, b, p, Level::structural}; }

/// A graph of any probabilities with edges of both levels.
Graph random_graph(unsigned seed, int nodes) {
  std::mt19937 random(seed);
  Graph graph;
  for (int i = 0; i < nodes; ++i) graph.sizes.push_back(1 + int(random() % 5000));
  for (int a = 0; a < nodes; ++a)
    for (int b = a + 1; b < nodes; ++b)
      if (random() % 4 == 0)
        graph.edges.push_back(
            {a, b, double(random() % 1001) / 1000, random() % 3 ? Level::structural : Level::assembly});
  return graph;
}

class SolverContract : public SubjectTest<Solver> {};

TEST_P(SolverContract, TakesAnEmptyGraph) { EXPECT_EQ(subject_->solve({}), Groups{}); }

TEST_P(SolverContract, LeavesNodesWithoutEdgesAlone) {
  EXPECT_EQ(subject_->solve({{10}, {}}), (Groups{0}));
  EXPECT_EQ(subject_->solve({{10, 2000, 1}, {}}), (Groups{0, 1, 2}));
}

TEST_P(SolverContract, JoinsWhatIsCertainlyOneObject) {
  EXPECT_EQ(subject_->solve({{100, 100}, {edge(0, 1, 1)}}), (Groups{0, 0}));
  EXPECT_EQ(subject_->solve({{100, 100, 100, 100}, {edge(0, 2, 1), edge(0, 3, 1), edge(1, 2, 0)}}),
            (Groups{0, 1, 0, 0}));
}

TEST_P(SolverContract, KeepsApartWhatIsCertainlyTwo) {
  EXPECT_EQ(subject_->solve({{100, 100}, {edge(0, 1, 0)}}), (Groups{0, 1}));
  EXPECT_EQ(subject_->solve({{100, 100, 100}, {edge(0, 1, 0), edge(0, 2, 0), edge(1, 2, 0)}}), (Groups{0, 1, 2}));
}

TEST_P(SolverContract, NumbersGroupsInOrderOfFirstAppearance) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    const Graph graph = random_graph(seed, 40);
    const Groups groups = subject_->solve(graph);
    ASSERT_EQ(groups.size(), graph.sizes.size());
    int next = 0;
    for (const int group : groups) {
      ASSERT_GE(group, 0);
      ASSERT_LE(group, next);
      next = std::max(next, group + 1);
    }
  }
}

TEST_P(SolverContract, GivesTheSameTwiceAndForAnyNumberOfThreads) {
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Graph graph = random_graph(seed, 60);
    const auto run = [&] { return subject_->solve(graph); };
    const Groups one = with_threads(1, run);
    EXPECT_EQ(with_threads(1, run), one);
    EXPECT_EQ(with_threads(8, run), one);
  }
}

GESTALT_CONFORMANCE(SolverContract, "solver");

}  // namespace
}  // namespace gestalt::conformance
