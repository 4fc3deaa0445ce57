// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/pipeline.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "gestalt/error.h"

namespace gestalt {

namespace {

/// Adds the time of its life to a sum.
class Stopwatch {
 public:
  explicit Stopwatch(double& milliseconds) : milliseconds_(milliseconds) {}
  ~Stopwatch() {
    milliseconds_ += std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }
  Stopwatch(const Stopwatch&) = delete;
  Stopwatch& operator=(const Stopwatch&) = delete;

 private:
  double& milliseconds_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// Groups of surfaces as segments, largest first; equal sizes in order of their first surface.
Segmentation assemble(const SurfaceSet& surfaces, Graph graph, const std::vector<int>& groups) {
  const int count = groups.empty() ? 0 : 1 + *std::max_element(groups.begin(), groups.end());
  std::vector<Segment> segments{std::size_t(count)};
  for (std::size_t s = 0; s < groups.size(); ++s) {
    Segment& segment = segments[std::size_t(groups[s])];
    segment.surfaces.push_back(int(s));
    segment.pixel_count += int(surfaces.surfaces[s].pixels.size());
  }
  std::stable_sort(segments.begin(), segments.end(),
                   [](const Segment& x, const Segment& y) { return x.pixel_count > y.pixel_count; });
  if (segments.size() > std::numeric_limits<std::uint16_t>::max())
    throw Error("the frame falls into " + std::to_string(segments.size()) +
                " segments, a 16-bit label image holds 65535; set the clusterer's parameters for larger patches");

  Segmentation result{cv::Mat_<std::uint16_t>(surfaces.labels.size(), std::uint16_t{0}), std::move(segments),
                      std::move(graph)};
  for (std::size_t i = 0; i < result.segments.size(); ++i)
    for (const int s : result.segments[i].surfaces)
      for (const int pixel : surfaces.surfaces[std::size_t(s)].pixels)
        result.labels.ptr<std::uint16_t>()[pixel] = std::uint16_t(i + 1);
  return result;
}

}  // namespace

Pipeline::Pipeline(Config config, const Registry& registry)
    : config_(std::move(config)),
      clusterer_(registry.create<Clusterer>(config_.clusterer.plugin, config_.clusterer.params)),
      surface_modelling_(SurfaceModellingParams::parameters().read(config_.surface_modelling)),
      classifier_(registry.create<Classifier>(config_.classifier.plugin, config_.classifier.params)),
      solver_(registry.create<Solver>(config_.solver.plugin, config_.solver.params)) {
  for (const ComponentConfig& fitter : config_.fitters)
    fitters_.push_back(registry.create<Fitter>(fitter.plugin, fitter.params));
  for (const ComponentConfig& relation : config_.relations)
    relations_.push_back({relation.name, registry.create<Relation>(relation.plugin, relation.params), relation.plugin});
  value_names_ = gestalt::value_names(relations_);
}

Model Pipeline::load_model() const {
  if (config_.model.empty())
    throw ModelError(
        "the config names no model (structural.model); train one with 'gestalt train SCENES --output MODEL'");
  return read_model(config_.model, *classifier_, config_.classifier.plugin, value_names_);
}

Percept Pipeline::perceive(const Frame& frame) const {
  if (!frame.has_colour())
    for (const NamedRelation& named : relations_)
      if (named.relation->needs_colour())
        throw InputError(
            frame.name + ": has no colour image, and relation '" + named.name +
            "' needs one; add rgb.png, or use a config without colour relations and a model trained for it");
  Percept percept;
  {
    const Stopwatch watch(percept.times.signal);
    percept.patches = clusterer_->cluster(frame);
  }
  {
    const Stopwatch watch(percept.times.primitive);
    percept.surfaces = model_surfaces(frame, percept.patches, fitters_, surface_modelling_);
  }
  {
    const Stopwatch watch(percept.times.structural);
    const Scene scene(frame, percept.patches, percept.surfaces);
    percept.relations = relate_neighbours(scene, relations_, config_.minimum_size);
  }
  return percept;
}

Segmentation Pipeline::decide(const Percept& percept, const Model& model, LevelTimes* times) const {
  LevelTimes ignored;
  LevelTimes& spent = times ? *times : ignored;
  Graph graph;
  {
    const Stopwatch watch(spent.structural);
    for (const Surface& surface : percept.surfaces.surfaces) graph.sizes.push_back(int(surface.pixels.size()));
    for (std::size_t i = 0; i < percept.relations.pairs.size(); ++i) {
      const auto [a, b] = percept.relations.pairs[i];
      graph.edges.push_back({a, b, model.probability(percept.relations.row(i)), Level::structural});
    }
  }
  const Stopwatch watch(spent.decision);
  const std::vector<int> groups = solver_->solve(graph);
  return assemble(percept.surfaces, std::move(graph), groups);
}

}  // namespace gestalt
