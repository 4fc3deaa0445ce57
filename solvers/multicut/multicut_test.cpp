// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "multicut.h"

#include <gtest/gtest.h>

#include <random>

#include "greedy_contraction.h"
#include "kernighan_lin.h"

namespace gestalt {
namespace {

using Groups = std::vector<int>;

Edge edge(int a, int b, double p, Level level = Level::structural) { return {a, b, p, level}; }

Multicut neutral_at_half() { return Multicut({.structural_probability = 0.5, .assembly_probability = 0.5}); }

double weight_within(const Multicut& solver, const Graph& graph, const Groups& groups) {
  double sum = 0;
  for (const Edge& e : graph.edges)
    if (groups[std::size_t(e.a)] == groups[std::size_t(e.b)]) sum += solver.weight(e);
  return sum;
}

/// The largest weight of all partitions: each node joins one of the groups of the nodes before it, or begins a new one.
double largest_weight(const Multicut& solver, const Graph& graph, Groups& groups, std::size_t node = 0, int used = 0) {
  if (node == groups.size()) return weight_within(solver, graph, groups);
  double best = -1e9;
  for (int group = 0; group <= used; ++group) {
    groups[node] = group;
    best = std::max(best, largest_weight(solver, graph, groups, node + 1, std::max(used, group + 1)));
  }
  return best;
}

Graph random_graph(int nodes, double share, std::mt19937& random) {
  std::uniform_real_distribution<double> uniform;
  Graph graph{std::vector<int>(std::size_t(nodes), 100), {}};
  for (int a = 0; a < nodes; ++a)
    for (int b = a + 1; b < nodes; ++b)
      if (uniform(random) < share)
        graph.edges.push_back(edge(a, b, uniform(random), uniform(random) < 0.5 ? Level::structural : Level::assembly));
  return graph;
}

TEST(Multicut, EdgesThatSpeakAgainstAJoinCount) {
  // 0 - 1 and 1 - 2 are likely, but 0 - 2 are surely two objects.
  const Graph graph{{9, 9, 9}, {edge(0, 1, 0.9), edge(0, 2, 0.001), edge(1, 2, 0.8)}};
  EXPECT_EQ(neutral_at_half().solve(graph), (Groups{0, 0, 1}));
}

TEST(Multicut, JoinsPartsThatAnOccluderDivides) {
  const Graph graph{{9, 9, 9}, {edge(0, 1, 0.1), edge(0, 2, 0.9, Level::assembly), edge(1, 2, 0.1)}};
  EXPECT_EQ(Multicut({}).solve(graph), (Groups{0, 1, 0}));
}

TEST(Multicut, LevelsHaveProbabilitiesAndAWeightOfTheirOwn) {
  const Graph structural{{9, 9}, {edge(0, 1, 0.6)}}, assembly{{9, 9}, {edge(0, 1, 0.6, Level::assembly)}};
  EXPECT_EQ(Multicut({}).solve(structural), (Groups{0, 0}));
  EXPECT_EQ(Multicut({}).solve(assembly), (Groups{0, 1}));
  const Graph both{{9, 9, 9}, {edge(0, 1, 0.8), edge(0, 2, 0.1, Level::assembly), edge(1, 2, 0.8)}};
  EXPECT_EQ(Multicut({.assembly_weight = 0.1}).solve(both), (Groups{0, 0, 0}));
  EXPECT_NE(Multicut({.assembly_weight = 2}).solve(both), (Groups{0, 0, 0}));
}

TEST(Multicut, IsNearTheOptimumOfSmallGraphs) {
  std::mt19937 random(5);
  const Multicut solver = neutral_at_half();
  int optimal = 0;
  double reached = 0, possible = 0;
  for (int i = 0; i < 200; ++i) {
    const Graph graph = random_graph(8, i % 2 ? 0.5 : 1, random);
    Groups groups(8);
    const double best = largest_weight(solver, graph, groups);
    const double found = weight_within(solver, graph, solver.solve(graph));
    EXPECT_LE(found, best + 1e-9);
    optimal += found > best - 1e-9;
    reached += found;
    possible += best;
  }
  EXPECT_GT(optimal, 180);
  EXPECT_GT(reached, 0.995 * possible);
}

TEST(Multicut, MovesAndJoinsImproveOnGreedyContraction) {
  std::mt19937 random(11);
  const Multicut solver = neutral_at_half();
  int better = 0;
  for (int i = 0; i < 50; ++i) {
    const Graph graph = random_graph(60, 0.2, random);
    WeightedGraph weighted(60);
    for (const Edge& e : graph.edges) {
      weighted[std::size_t(e.a)].emplace_back(e.b, solver.weight(e));
      weighted[std::size_t(e.b)].emplace_back(e.a, solver.weight(e));
    }
    const double greedy = weight_within(solver, graph, contract_greedily(weighted));
    const double improved = weight_within(solver, graph, solver.solve(graph));
    EXPECT_GE(improved, greedy - 1e-9);
    better += improved > greedy + 1e-9;
  }
  EXPECT_GT(better, 30);

  // Two halves that belong together, and a node on the wrong side.
  Groups groups{0, 0, 2, 2, 0};
  const WeightedGraph wrong{{{1, 3}}, {{0, 3}}, {{3, 3}, {4, 2}}, {{2, 3}, {4, 2}}, {{2, 2}, {3, 2}}};
  improve_by_moves(wrong, groups);
  EXPECT_EQ(groups[4], groups[2]);
  Groups halves{0, 1};
  improve_by_moves({{{1, 1}}, {{0, 1}}}, halves);
  EXPECT_EQ(halves[0], halves[1]);
  Groups one{0, 0};
  improve_by_moves({{{1, -1}}, {{0, -1}}}, one);
  EXPECT_NE(one[0], one[1]);
}

TEST(Multicut, WorkIsBounded) {
  // A graph of thousands of nodes ends, and is not worse than without moves.
  std::mt19937 random(2);
  const Graph graph = random_graph(1500, 0.05, random);
  const Multicut solver = neutral_at_half();
  const Groups groups = solver.solve(graph);
  EXPECT_EQ(groups.size(), 1500u);
  EXPECT_GT(weight_within(solver, graph, groups), 0);
}

TEST(Multicut, NodesWithoutEdgesStayAlone) {
  EXPECT_EQ(Multicut({}).solve({{5, 5}, {}}), (Groups{0, 1}));
  EXPECT_EQ(Multicut({}).solve({}), Groups{});
}

}  // namespace
}  // namespace gestalt
