// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Components that break their contract in a pipeline: an error with their name, whatever they give.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/core/plugin/plugin.h"
#include "gestalt/core/plugin/running_component.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

/// A component of the program: what make gives.
template <class Kind>
void add(Registry& registry, const std::string& name, std::function<std::unique_ptr<Kind>()> make) {
  registry.add<Kind>({"", name, "1.0.0", "", "this test"}, {{}, [make](const ParameterValues&) { return make(); }});
}

struct GivenPatches final : Clusterer {
  std::function<PatchMap(const Frame&)> give;
  explicit GivenPatches(std::function<PatchMap(const Frame&)> f) : give(std::move(f)) {}
  PatchMap cluster(const Frame& frame) const override { return give(frame); }
};

struct GivenGroups final : Solver {
  std::function<std::vector<int>(std::size_t)> give;
  explicit GivenGroups(std::function<std::vector<int>(std::size_t)> f) : give(std::move(f)) {}
  std::vector<int> solve(const Graph& graph) const override { return give(graph.sizes.size()); }
};

struct GivenProbability final : Classifier {
  double p;
  explicit GivenProbability(double value) : p(value) {}
  struct Constant final : Predictor {
    double p;
    explicit Constant(double value) : p(value) {}
    double probability(std::span<const double>) const override { return p; }
    nlohmann::json state() const override { return p; }
  };
  std::unique_ptr<Predictor> train(const Samples&) const override { return std::make_unique<Constant>(p); }
  std::unique_ptr<Predictor> restore(const nlohmann::json&, std::size_t) const override {
    return std::make_unique<Constant>(p);
  }
};

struct NoMeasure final : Relation {
  const std::vector<RelationValue>& values() const override {
    static const std::vector<RelationValue> values{{"r_none", 0, 1, "nothing"}};
    return values;
  }
  std::unique_ptr<Measure> bind(const Scene&) const override { return nullptr; }
};

/// Segments a scene with the default config but for the one component; gives what is thrown.
template <class Kind>
std::string failure(const std::string& override, std::function<std::unique_ptr<Kind>()> make) {
  Registry registry(plugin_search_path({}));
  add<Kind>(registry, "given", std::move(make));
  const LoadedConfig loaded(ConfigTree(default_config(), {override}), std::move(registry));
  const Pipeline pipeline(loaded.config, loaded.registry);
  const auto known = test::ridge(true);
  try {
    const Percept percept = pipeline.perceive(known.frame);
    const auto trained = [&](Level level) {
      const ExpectedModel expected = pipeline.expected_model(level);
      const Samples two{expected.names.size(), std::vector<double>(2 * expected.names.size()), {0, 1}};
      return train_model(expected.classifier, expected.classifier_name, expected.names, two, {}, "");
    };
    pipeline.decide(percept, {trained(Level::structural), trained(Level::assembly)});
  } catch (const PluginError& error) {
    return error.what();
  }
  return "";
}

std::string failure_of_clusterer(const std::function<PatchMap(const Frame&)>& give) {
  return failure<Clusterer>("signal.clusterer=given", [give] { return std::make_unique<GivenPatches>(give); });
}

std::string failure_of_solver(const std::function<std::vector<int>(std::size_t)>& give) {
  return failure<Solver>("decision.solver=given", [give] { return std::make_unique<GivenGroups>(give); });
}

PatchMap sound(const Frame& frame) {
  PatchMap patches{cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size(), {0, 0, -1}), 1};
  for (int v = 0; v < frame.height(); ++v)
    for (int u = 0; u < frame.width(); ++u) patches.labels(v, u) = frame.depth(v, u) > 0;
  return patches;
}

TEST(Contract, ASoundComponentIsTaken) {
  EXPECT_EQ(failure_of_clusterer(sound), "");
  EXPECT_EQ(failure_of_solver([](std::size_t n) { return std::vector<int>(n, 0); }), "");
}

TEST(Contract, OfAClusterer) {
  const auto spoilt = [](const std::function<void(PatchMap&)>& spoil) {
    return failure_of_clusterer([spoil](const Frame& frame) {
      PatchMap patches = sound(frame);
      spoil(patches);
      return patches;
    });
  };
  const std::vector<std::pair<std::string, std::function<void(PatchMap&)>>> faults{
      {"another size", [](PatchMap& p) { p = {}; }},
      {"another size", [](PatchMap& p) { p.normals = p.normals.rowRange(0, 2); }},
      {"the label 7", [](PatchMap& p) { p.labels(3, 3) = 7; }},
      {"the label -1", [](PatchMap& p) { p.labels(3, 3) = -1; }},
      {"not finite", [](PatchMap& p) { p.normals(3, 3)[1] = std::numeric_limits<float>::quiet_NaN(); }},
      {"failed: made to", [](PatchMap&) { throw std::runtime_error("made to"); }},
      {"no message", [](PatchMap&) { throw 7; }}};
  for (const auto& [words, spoil] : faults) {
    const std::string message = spoilt(spoil);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_NE(message.find("clusterer 'given'"), std::string::npos) << message;
  }
}

TEST(Contract, OfASolver) {
  for (const auto& give : std::vector<std::function<std::vector<int>(std::size_t)>>{
           [](std::size_t) { return std::vector<int>{}; }, [](std::size_t n) { return std::vector<int>(n + 1, 0); },
           [](std::size_t n) { return std::vector<int>(n, -1); },
           [](std::size_t n) { return std::vector<int>(n, int(n)); }}) {
    const std::string message = failure_of_solver(give);
    EXPECT_NE(message.find("solver 'given' gave"), std::string::npos) << message;
  }
}

TEST(Contract, OfAClassifier) {
  for (const double p : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string message =
        failure<Classifier>("structural.classifier=given", [p] { return std::make_unique<GivenProbability>(p); });
    EXPECT_NE(message.find("classifier 'given' gave the probability"), std::string::npos) << message;
  }
}

TEST(Contract, OfARelation) {
  const std::string message =
      failure<Relation>("structural.relations.given=on", [] { return std::make_unique<NoMeasure>(); });
  EXPECT_NE(message.find("relation 'given' gave no measure"), std::string::npos) << message;
}

TEST(RunningComponent, IsThatOfTheThreadElseTheLastBegun) {
  std::string inside, elsewhere;
  failure_of_solver([&](std::size_t n) {
    inside = running_component();
    std::thread([&] { elsewhere = running_component(); }).join();
    return std::vector<int>(n, 0);
  });
  EXPECT_EQ(inside, "solver 'given'");
  EXPECT_EQ(elsewhere, "solver 'given'");
}

// The thread is older than the names, so that only what it reads them by makes them whole for it.
TEST(RunningComponent, IsSeenByAThreadThatWatches) {
  std::atomic<bool> seen{false}, over{false};
  std::thread watcher([&] {
    while (!seen && !over)
      for (const char* name : running_components())
        if (std::string(name) == "solver 'given'") seen = true;
  });
  failure_of_solver([&](std::size_t n) {
    const auto patience = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (!seen && std::chrono::steady_clock::now() < patience) std::this_thread::yield();
    return std::vector<int>(n, 0);
  });
  over = true;
  watcher.join();
  EXPECT_TRUE(seen);
}

}  // namespace
}  // namespace gestalt
