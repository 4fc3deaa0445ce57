// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Classifiers on generated tables, solvers on generated graphs.

#include <gtest/gtest.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <set>

#include "cases.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/model.h"
#include "gestalt/core/plugin/solver.h"

namespace gestalt::properties {
namespace {

double any_number(Chance& chance) {
  static const std::vector<double> odd{0, -0.0, 1, -1, 5e-324, 1e-300, 1e30, -1e30, 1e100, -1e100};
  return chance.one_in(6) ? chance.one_of(odd) : chance.real(-1, 1);
}

/// With constant, equal and contradictory rows and columns.
Samples any_samples(Chance& chance) {
  Samples samples;
  samples.columns = std::size_t(chance.whole(1, 4));
  const bool constant = chance.one_in(5);
  for (int row = chance.whole(2, 14); row > 0; --row) {
    samples.positive.push_back(std::uint8_t(row <= 2 ? row % 2 : chance.whole(0, 1)));
    for (std::size_t c = 0; c < samples.columns; ++c)
      samples.values.push_back(constant || (c == 1 && samples.columns > 2) ? 0.5 : any_number(chance));
  }
  return samples;
}

TEST(Classifiers, GiveProbabilitiesAndReadBack) {
  for_each_case([](Chance& chance) {
    const Samples raw = any_samples(chance);
    Samples scaled = raw;
    const Scaling scaling = Scaling::of(raw);
    for (std::size_t i = 0; i < raw.rows(); ++i)
      scaling.apply(raw.row(i), {scaled.values.data() + i * raw.columns, raw.columns});
    std::vector<double> row(raw.columns), asked(raw.columns);
    for (double& value : row) value = any_number(chance);
    scaling.apply(row, asked);
    for (const std::string& name : registry().names("classifier")) {
      SCOPED_TRACE(name);
      // Trees by the thousand take time and add nothing here.
      ParameterValues params = any_params(chance, "classifier", name);
      if (params.contains("trees")) params["trees"] = std::int64_t(chance.whole(1, 5));
      const auto classifier = registry().create<Classifier>(name, params);
      const auto predictor = classifier->train(scaled);
      ASSERT_TRUE(predictor);
      const double p = predictor->probability(asked);
      EXPECT_TRUE(p >= 0 && p <= 1) << p;
      const std::string text = predictor->state().dump();
      EXPECT_EQ(classifier->restore(nlohmann::json::parse(text), raw.columns)->probability(asked), p);
    }
  });
}

TEST(Classifiers, RefuseToLearnOfOneClass) {
  Samples samples{1, {0.1, 0.2, 0.3}, {1, 1, 1}};
  for (const std::string& name : registry().names("classifier"))
    EXPECT_THROW(registry().create<Classifier>(name, {})->train(samples), ModelError) << name;
}

Graph any_graph(Chance& chance, int largest) {
  static const std::vector<double> decided{0, 1, 0.5, 5e-324, 0.49999999999999994, 0.9999999999999999};
  Graph graph;
  for (int nodes = chance.whole(0, largest); nodes > 0; --nodes) graph.sizes.push_back(chance.whole(1, 1'000'000));
  const int count = int(graph.sizes.size());
  const bool all = chance.one_in(6) && count < 40;
  std::set<std::pair<int, int>> pairs;
  for (int a = 0; all && a < count; ++a)
    for (int b = a + 1; b < count; ++b) pairs.emplace(a, b);
  for (int i = chance.whole(0, 3 * count); i > 0 && count > 1; --i) {
    const int a = chance.whole(0, count - 2);
    pairs.emplace(a, chance.whole(a + 1, count - 1));
  }
  for (const auto& [a, b] : pairs)
    graph.edges.push_back({a, b, chance.one_in(3) ? chance.one_of(decided) : chance.real(0, 1),
                           chance.one_in(2) ? Level::structural : Level::assembly});
  return graph;
}

void expect_groups(const Solver& solver, const Graph& graph) {
  const std::vector<int> groups = solver.solve(graph);
  ASSERT_EQ(groups.size(), graph.sizes.size());
  int next = 0;
  for (const int group : groups) {
    ASSERT_TRUE(group >= 0 && group <= next) << "groups are not numbered in order of first appearance";
    next = std::max(next, group + 1);
  }
  EXPECT_EQ(solver.solve(graph), groups) << "another solution for the same graph";
}

TEST(Solvers, NumberEveryNodesGroupInOrder) {
  for_each_case([](Chance& chance) {
    const Graph graph = any_graph(chance, 30);
    for (const std::string& name : registry().names("solver")) {
      SCOPED_TRACE(name);
      expect_groups(*any_component<Solver>(chance, name), graph);
    }
  });
}

TEST(Solvers, TakeAsManyNodesAsAnImageHasLabels) {
  Chance chance(1);
  Graph graph;
  graph.sizes.assign(65'535, 1);
  for (int a = 0; a + 257 < 65'535; ++a)
    for (const int b : {a + 1, a + 256, a + 257}) graph.edges.push_back({a, b, chance.real(0, 1), Level::structural});
  for (const std::string& name : registry().names("solver")) {
    SCOPED_TRACE(name);
    expect_groups(*registry().create<Solver>(name, {}), graph);
  }
}

}  // namespace
}  // namespace gestalt::properties
