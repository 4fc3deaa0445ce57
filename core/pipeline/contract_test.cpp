// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Components that break their contract in a pipeline: an error with their name, whatever they give.

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <limits>
#include <nlohmann/json.hpp>
#include <thread>

#include "checked_fitter.h"
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
std::string failure(const std::string& override, std::function<std::unique_ptr<Kind>()> make,
                    std::vector<std::string> overrides = {}) {
  overrides.push_back(override);
  Registry registry(plugin_search_path({}));
  add<Kind>(registry, "given", std::move(make));
  const LoadedConfig loaded(ConfigTree(default_config(), overrides), std::move(registry));
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
      {"no pixel of the label 2, of 2 patches", [](PatchMap& p) { p.count = 2; }},
      {"2147483647 patches", [](PatchMap& p) { p.count = 2147483647; }},
      {"-1 patches", [](PatchMap& p) { p.count = -1; }},
      {"a part of a larger image",
       [](PatchMap& p) {
         cv::Mat_<int> larger(p.labels.rows, p.labels.cols + 7, 1);
         larger.colRange(0, p.labels.cols).setTo(1);
         p.labels = larger.colRange(0, p.labels.cols);
       }},
      {"cut_from of 3 numbers for 1 patches",
       [](PatchMap& p) {
         p.cut_from = {1, 1, 1};
       }},
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
    EXPECT_NE(message.find("solver 'given' returned"), std::string::npos) << message;
  }
}

TEST(Contract, OfAClassifier) {
  for (const double p : {-0.1, 1.1, std::numeric_limits<double>::quiet_NaN()}) {
    const std::string message =
        failure<Classifier>("structural.classifier=given", [p] { return std::make_unique<GivenProbability>(p); });
    EXPECT_NE(message.find("classifier 'given' returned the probability"), std::string::npos) << message;
  }
}

TEST(Contract, OfARelation) {
  const std::string message =
      failure<Relation>("structural.relations.given=on", [] { return std::make_unique<NoMeasure>(); });
  EXPECT_NE(message.find("relation 'given' returned no measure"), std::string::npos) << message;
}

/// A fitter of planes whose answers are spoilt.
struct SpoiltFitter final : Fitter {
  struct Spoil {
    float point = 0, normal = 0, squared_distance = 0, parameter = 0;  // added
    double in_json = 0, count = 0;
    std::string throws{};
  };
  struct Spoilt final : SurfaceModel {
    Spoil spoil;
    std::shared_ptr<const SurfaceModel> plane;
    Spoilt(Spoil how, std::shared_ptr<const SurfaceModel> sound) : spoil(std::move(how)), plane(std::move(sound)) {}
    std::string type() const override { return "plane"; }  // copied from another plugin, as it may happen
    Foot foot(const Eigen::Vector3f& p) const override {
      if (spoil.throws == "foot") throw std::runtime_error("made to");
      Foot foot = plane->foot(p);
      foot.point.z() += spoil.point, foot.normal.x() += spoil.normal;
      return foot;
    }
    float squared_distance(const Eigen::Vector3f& p) const override {
      return plane->squared_distance(p) + spoil.squared_distance;
    }
    std::optional<Eigen::Vector2d> parameters(const Eigen::Vector3f& p) const override {
      return Eigen::Vector2d(p.x() + spoil.parameter, p.y());
    }
    nlohmann::json to_json() const override { return {{"type", "plane"}, {"more", {1.0, spoil.in_json}}}; }
  };

  Spoil spoil;
  explicit SpoiltFitter(Spoil how) : spoil(std::move(how)) {}
  double parameter_count() const override { return 4 + spoil.count; }
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override {
    if (spoil.throws == "fit") throw std::runtime_error("made to");
    return std::make_shared<Spoilt>(spoil, test::exact_plane(points.front(), {0, 0, -1}));
  }
  std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a, std::span<const Eigen::Vector3f> points,
                                                 const SurfaceModel& b,
                                                 std::span<const Eigen::Vector3f>) const override {
    EXPECT_TRUE(dynamic_cast<const Spoilt*>(&a) && dynamic_cast<const Spoilt*>(&b)) << "its own surfaces";
    return fit(points);
  }
};

// Relations ask for closest points, results for parameters; neither is to blame for what they get.
TEST(Contract, OfAFitter) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const auto spoilt = [](SpoiltFitter::Spoil spoil) {
    return failure<Fitter>("primitive.fitters.given=on", [spoil] { return std::make_unique<SpoiltFitter>(spoil); },
                           {"primitive.fitters.plane=off"});
  };
  EXPECT_EQ(spoilt({}), "");
  const std::vector<std::pair<std::string, SpoiltFitter::Spoil>> faults{
      {"returned a surface whose closest point", {.point = nan}},
      {"returned a surface whose closest point", {.normal = -std::numeric_limits<float>::infinity()}},
      {"returned a surface whose distance", {.squared_distance = nan}},
      {"returned a surface whose distance", {.squared_distance = -9}},
      {"returned a number of parameters", {.count = double(nan)}},
      {"failed: made to", {.throws = "fit"}},
      {"failed: made to", {.throws = "foot"}}};
  for (const auto& [words, spoil] : faults) {
    const std::string message = spoilt(spoil);
    EXPECT_NE(message.find("fitter 'given' " + words), std::string::npos) << words << ": " << message;
  }
}

TEST(Contract, OfASurfaceInAResult) {
  constexpr float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<Eigen::Vector3f> points{{0, 0, 1}};
  const auto message = [&](SpoiltFitter::Spoil spoil, const auto& ask) -> std::string {
    const auto fitter = checked_fitter(std::make_shared<SpoiltFitter>(spoil), "given");
    try {
      ask(*fitter->fit(points));
    } catch (const PluginError& error) {
      return error.what();
    }
    return "";
  };
  const auto parameters = [&](const SurfaceModel& surface) { surface.parameters(points[0]); };
  const auto json = [](const SurfaceModel& surface) { surface.to_json(); };
  EXPECT_EQ(message({}, parameters), "");
  EXPECT_EQ(message({}, json), "");
  EXPECT_NE(message({.parameter = nan}, parameters).find("fitter 'given' returned parameters"), std::string::npos);
  EXPECT_NE(message({.in_json = double(nan)}, json).find("fitter 'given' returned a surface"), std::string::npos);
}

/// Notes the component that is running when it is destroyed.
struct Witness {
  std::vector<std::string>& seen;
  explicit Witness(std::vector<std::string>& names) : seen(names) {}
  Witness(const Witness&) = delete;
  Witness& operator=(const Witness&) = delete;
  ~Witness() { seen.emplace_back(own_component() ? own_component() : "none"); }
};

// What a destructor does, the crash report says of its component, not of the one that was called last.
TEST(RunningComponent, IsTheOneWhoseDestructorRuns) {
  struct Observed final : Relation {
    struct Seen final : Observation {
      Witness witness;
      explicit Seen(std::vector<std::string>& names) : witness(names) {}
    };
    struct Zero final : Measure {
      Witness witness;
      explicit Zero(std::vector<std::string>& names) : witness(names) {}
      void operator()(const SurfacePair&, std::span<double> values) const override { values[0] = 0; }
    };
    std::vector<std::string>&own, &measures, &observations;
    Witness witness{own};
    Observed(std::vector<std::string>& a, std::vector<std::string>& b, std::vector<std::string>& c)
        : own(a), measures(b), observations(c) {}
    const std::vector<RelationValue>& values() const override {
      static const std::vector<RelationValue> values{{"r_none", 0, 1, "nothing"}};
      return values;
    }
    std::unique_ptr<Observation> observe(const Images&) const override { return std::make_unique<Seen>(observations); }
    std::unique_ptr<Measure> bind(const Scene&) const override { return std::make_unique<Zero>(measures); }
  };
  std::vector<std::string> own, measures, observations;
  EXPECT_EQ(failure<Relation>("structural.relations.given=on",
                              [&] { return std::make_unique<Observed>(own, measures, observations); }),
            "");
  EXPECT_EQ(own, std::vector<std::string>{"relation 'given'"});
  EXPECT_EQ(measures, std::vector<std::string>{"relation 'given'"});
  ASSERT_EQ(observations.size(), 1u);
  EXPECT_NE(observations[0].find("relation '"), std::string::npos) << observations[0];
  EXPECT_NE(observations[0].find("'given'"), std::string::npos) << observations[0];

  struct Learner final : Classifier {
    struct Learned final : Predictor {
      Witness witness;
      explicit Learned(std::vector<std::string>& names) : witness(names) {}
      double probability(std::span<const double>) const override { return 0.5; }
      nlohmann::json state() const override { return 0; }
    };
    std::vector<std::string>& seen;
    explicit Learner(std::vector<std::string>& names) : seen(names) {}
    std::unique_ptr<Predictor> train(const Samples&) const override { return std::make_unique<Learned>(seen); }
    std::unique_ptr<Predictor> restore(const nlohmann::json&, std::size_t) const override { return nullptr; }
  };
  std::vector<std::string> predictors;
  EXPECT_EQ(failure<Classifier>("structural.classifier=given", [&] { return std::make_unique<Learner>(predictors); }),
            "");
  EXPECT_EQ(predictors, std::vector<std::string>{"classifier 'given'"});

  struct Witnessed final : SurfaceModel {
    Witness witness;
    explicit Witnessed(std::vector<std::string>& names) : witness(names) {}
    std::string type() const override { return "given"; }
    Foot foot(const Eigen::Vector3f& p) const override { return {p, {0, 0, -1}}; }
    nlohmann::json to_json() const override { return {}; }
  };
  struct FitterOfWitnesses final : Fitter {
    std::vector<std::string>& seen;
    explicit FitterOfWitnesses(std::vector<std::string>& names) : seen(names) {}
    double parameter_count() const override { return 1; }
    std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f>) const override {
      return std::make_shared<Witnessed>(seen);
    }
  };
  std::vector<std::string> surfaces;
  checked_fitter(std::make_shared<FitterOfWitnesses>(surfaces), "given")->fit({});
  EXPECT_EQ(surfaces, std::vector<std::string>{"fitter 'given'"});
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
