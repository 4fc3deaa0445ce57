// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

/// A component of each kind whose parameters have every type, for tests that need a registry and no real component.

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gestalt/core/plugin/plugin.h"

namespace gestalt {
namespace {

struct TestParams {
  bool smooth = true;
  int bins = 4;
  double sigma = 1.5;
  std::string norm = "l2";

  static const Parameters<TestParams>& declared() {
    static const auto parameters = Parameters<TestParams>()
                                       .boolean("smooth", &TestParams::smooth, "whether the image is smoothed")
                                       .integer("bins", &TestParams::bins, 1, 16, "", "bins of the histogram")
                                       .real("sigma", &TestParams::sigma, 0, 10, "m", "width of the kernel")
                                       .choice("norm", &TestParams::norm, {"l1", "l2"}, "norm of the difference");
    return parameters;
  }
};

/// Kind, and everything of a component but the kind's own functions.
template <class Kind>
struct Component : Kind {
  using Params = TestParams;
  static const Parameters<Params>& parameters() { return Params::declared(); }
};

struct TestClusterer final : Component<Clusterer> {
  explicit TestClusterer(const Params&) {}
  PatchMap cluster(const Frame&) const override { return {}; }
};

struct TestFitter final : Component<Fitter> {
  explicit TestFitter(const Params&) {}
  double parameter_count() const override { return 3; }
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f>) const override { return nullptr; }
};

struct TestRelation final : Component<Relation> {
  explicit TestRelation(const Params&) {}
  const std::vector<RelationValue>& values() const override {
    static const std::vector<RelationValue> values{
        {"r_one", 0, 1, "always 0"}, {"r_two", 0, 1, "always 0"}, {"r_three", 0, 1, "always 0"}};
    return values;
  }
  std::unique_ptr<Measure> bind(const Scene&) const override {
    struct Zero final : Measure {
      void operator()(const SurfacePair&, std::span<double> values) const override {
        std::fill(values.begin(), values.end(), 0);
      }
    };
    return std::make_unique<Zero>();
  }
};

struct TestClassifier final : Component<Classifier> {
  explicit TestClassifier(const Params&) {}
  std::unique_ptr<Predictor> train(const Samples&) const override { return restore({}, 0); }
  std::unique_ptr<Predictor> restore(const nlohmann::json&, std::size_t) const override {
    struct Undecided final : Predictor {
      double probability(std::span<const double>) const override { return 0.5; }
      nlohmann::json state() const override { return nullptr; }
    };
    return std::make_unique<Undecided>();
  }
};

struct TestSolver final : Component<Solver> {
  explicit TestSolver(const Params&) {}
  std::vector<int> solve(const Graph& graph) const override { return std::vector<int>(graph.sizes.size(), 0); }
};

}  // namespace
}  // namespace gestalt

GESTALT_PLUGIN(gestalt::component<gestalt::TestClusterer>("steps", "1.0.0", "A clusterer"),
               gestalt::component<gestalt::TestClusterer>("grid", "1.0.0", "Another clusterer"),
               gestalt::component<gestalt::TestFitter>("flat", "1.0.0", "A fitter"),
               gestalt::component<gestalt::TestFitter>("round", "1.0.0", "Another fitter"),
               gestalt::component<gestalt::TestRelation>("colour", "1.0.0", "A relation"),
               gestalt::component<gestalt::TestRelation>("texture", "1.0.0", "Another relation"),
               gestalt::component<gestalt::TestRelation>("border", "1.0.0", "A third relation"),
               gestalt::component<gestalt::TestClassifier>("line", "1.0.0", "A classifier"),
               gestalt::component<gestalt::TestClassifier>("tree", "1.0.0", "Another classifier"),
               gestalt::component<gestalt::TestSolver>("cut", "1.0.0", "A solver"))
