// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// One component of each kind that loads and breaks its contract. Every fault is one that the conformance suite must
// find: see conformance_test.cpp.

#include <algorithm>
#include <atomic>
#include <limits>
#include <nlohmann/json.hpp>

#include "gestalt/core/plugin/plugin.h"

namespace {

using namespace gestalt;

template <class Params>
const Parameters<Params>& no_parameters() {
  static const Parameters<Params> none;
  return none;
}

/// Grows with every use of anything here: what depends on it is not deterministic.
int uses() {
  static std::atomic<int> count = 0;
  return ++count;
}

/// Labels pixels without depth, counts patches that are not there, and turns its normals away.
class UnfitClusterer final : public Clusterer {
 public:
  struct Params {};
  static const Parameters<Params>& parameters() { return no_parameters<Params>(); }
  explicit UnfitClusterer(const Params&) {}
  PatchMap cluster(const Frame& frame) const override {
    return {cv::Mat_<int>(frame.depth.size(), 1), cv::Mat_<cv::Vec3f>(frame.depth.size(), {0, 0, 1}), 1 + uses()};
  }
};

/// A surface that no point is near to, whose type is not the fitter's name.
class FarAway final : public SurfaceModel {
 public:
  std::string type() const override { return "far"; }
  Foot foot(const Eigen::Vector3f& p) const override { return {p + Eigen::Vector3f(float(uses()), 0, 0), {0, 0, 2}}; }
  nlohmann::json to_json() const override { return nlohmann::json::object(); }
};

class UnfitFitter final : public Fitter {
 public:
  struct Params {};
  static const Parameters<Params>& parameters() { return no_parameters<Params>(); }
  explicit UnfitFitter(const Params&) {}
  double parameter_count() const override { return 0; }
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f>) const override {
    return std::make_shared<FarAway>();
  }
};

/// Asymmetric, out of its range, without an end, and different at each call; reads colour without saying so.
class UnfitMeasure final : public Measure {
 public:
  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = pair.a < pair.b ? 0.25 : 0.75;
    values[1] = 2;
    values[2] = pair.border ? 0 : std::numeric_limits<double>::infinity();
    values[3] = uses();
    values[4] = pair.a;
  }
};

class UnfitRelation final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters() { return no_parameters<Params>(); }
  explicit UnfitRelation(const Params&) {}
  const std::vector<RelationValue>& values() const override {
    static const std::vector<RelationValue> values{{"r_asymmetric", 0, 1, "differs by order"},
                                                   {"r_out", 0, 1, "2"},
                                                   {"r_infinite", 0, 1, "has no end"},
                                                   {"r_calls", 0, 1e9, "counts calls"},
                                                   {"r_calls", 0, 1e9, ""}};
    return values;
  }
  std::unique_ptr<Measure> bind(const Scene& scene) const override {
    scene.grey();
    return std::make_unique<UnfitMeasure>();
  }
};

/// Believes everything it is given, and finds everything equally probable.
class UnfitPredictor final : public Predictor {
 public:
  explicit UnfitPredictor(double p) : p_(p) {}
  double probability(std::span<const double>) const override { return p_; }
  void probabilities(std::span<const double>, std::span<double> p) const override {
    std::fill(p.begin(), p.end(), p_ / 2);
  }
  nlohmann::json state() const override { return {{"p", p_}, {"note", "not needed"}}; }

 private:
  double p_;
};

class UnfitClassifier final : public Classifier {
 public:
  struct Params {};
  static const Parameters<Params>& parameters() { return no_parameters<Params>(); }
  explicit UnfitClassifier(const Params&) {}
  std::unique_ptr<Predictor> train(const Samples&) const override {
    return std::make_unique<UnfitPredictor>(1.5 + uses());
  }
  std::unique_ptr<Predictor> restore(const nlohmann::json&, std::size_t) const override {
    return std::make_unique<UnfitPredictor>(7);
  }
};

/// Puts everything, and one node too many, in a group of another number each time.
class UnfitSolver final : public Solver {
 public:
  struct Params {};
  static const Parameters<Params>& parameters() { return no_parameters<Params>(); }
  explicit UnfitSolver(const Params&) {}
  std::vector<int> solve(const Graph& graph) const override { return std::vector<int>(graph.sizes.size() + 1, uses()); }
};

/// What complete() would refuse, this factory takes; its default lies out of range.
const void* careless() {
  static const Factory<Solver> factory{
      {{"level", Parameter::Type::integer, std::int64_t{9}, 0, 3, {}, "", "any number"}},
      [](const ParameterValues&) { return std::make_unique<UnfitSolver>(UnfitSolver::Params{}); }};
  return &factory;
}

/// Cannot be made, with whatever values.
const void* unwilling() {
  static const Factory<Solver> factory{
      {{"willing", Parameter::Type::boolean, false, 0, 1, {}, "", "makes no difference"}},
      [](const ParameterValues&) { return nullptr; }};
  return &factory;
}

}  // namespace

GESTALT_PLUGIN(component<UnfitClusterer>("clusterer", "1.0.0", "Breaks the contract of a clusterer"),
               component<UnfitFitter>("fitter", "1.0.0", "Breaks the contract of a fitter"),
               component<UnfitRelation>("relation", "1.0.0", "Breaks the contract of a relation"),
               component<UnfitClassifier>("classifier", "1.0.0", "Breaks the contract of a classifier"),
               component<UnfitSolver>("solver", "1.0.0", "Breaks the contract of a solver"),
               {"solver", "Careless", "one", "", &careless},
               {"solver", "unwilling", "1.0.0", "Is never made", &unwilling})
