// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Each level of each bundled config alone, on one synthetic scene and the results of the levels below. Unlike in a
// pipeline the two levels of grouping share nothing here: each binds its own relations; and the decision is the
// solver's alone, without the roles of the surfaces.

#include <benchmark/benchmark.h>

#include <iostream>

#include "configs.h"
#include "gestalt/synthesis/synthesis.h"

namespace {

using namespace gestalt;

/// The components of a config, and what a frame is at each level.
class Levels {
 public:
  Levels(const std::string& config, const Frame& frame)
      : segmenter_(bench::bundled_config(config)),
        frame_(frame),
        percept_(segmenter_.pipeline().perceive(frame)),
        graph_(segmenter_.pipeline().decide(percept_, segmenter_.models()).graph) {
    frame_.noise = percept_.frame().noise;
  }

  bool with_assembly() const { return config().with_assembly; }

  void signal(benchmark::State& state) const {
    const auto clusterer = create<Clusterer>(config().clusterer);
    for (auto _ : state) benchmark::DoNotOptimize(clusterer->cluster(frame_));
  }

  /// By the pipeline's own clock.
  void primitive(benchmark::State& state) const {
    for (auto _ : state) state.SetIterationTime(segmenter_.pipeline().perceive(frame_).times.primitive / 1000);
  }

  void structural(benchmark::State& state) const {
    const double size = config().structural.minimum_size * percept_.pixel_density;
    group(state, config().structural, segmenter_.models().structural, neighbour_pairs(percept_.surfaces(), size));
  }

  void assembly(benchmark::State& state) const {
    const double size = config().assembly->minimum_size * percept_.pixel_density;
    group(state, *config().assembly, *segmenter_.models().assembly, non_neighbour_pairs(percept_.surfaces(), size));
  }

  void decision(benchmark::State& state) const {
    const auto solver = create<Solver>(config().solver);
    for (auto _ : state) benchmark::DoNotOptimize(solver->solve(graph_));
  }

 private:
  const Config& config() const { return segmenter_.pipeline().config(); }

  template <class Kind>
  std::shared_ptr<const Kind> create(const ComponentConfig& component) const {
    return segmenter_.registry().create<Kind>(component.plugin, component.params);
  }

  /// Relations and classification of the pairs; items are pairs.
  void group(benchmark::State& state, const LevelConfig& level, const Model& model,
             const std::vector<SurfacePair>& pairs) const {
    std::vector<NamedRelation> relations;
    for (const ComponentConfig& component : level.relations)
      relations.push_back({component.name, create<Relation>(component), component.plugin, component.values});
    for (auto _ : state) {
      state.PauseTiming();
      const Scene scene(frame_, percept_.patches(), percept_.surfaces());
      state.ResumeTiming();
      const RelationTable table = relate(pairs, relations, Measures(scene, relations));
      for (std::size_t i = 0; i < table.pairs.size(); ++i) benchmark::DoNotOptimize(model.probability(table.row(i)));
    }
    state.SetItemsProcessed(state.iterations() * std::int64_t(pairs.size()));
  }

  Segmenter segmenter_;
  Frame frame_;
  Percept percept_;
  Graph graph_;
};

void add_benchmarks(const std::string& config, const std::shared_ptr<const Levels>& levels) {
  const auto add = [&](const std::string& level, void (Levels::*run)(benchmark::State&) const) {
    return benchmark::RegisterBenchmark((config + '/' + level).c_str(),
                                        [levels, run](benchmark::State& state) { (*levels.*run)(state); })
        ->Unit(benchmark::kMillisecond);
  };
  add("signal", &Levels::signal)->UseRealTime();
  add("primitive", &Levels::primitive)->UseManualTime();
  add("structural", &Levels::structural)->UseRealTime();
  if (levels->with_assembly()) add("assembly", &Levels::assembly)->UseRealTime();
  add("decision", &Levels::decision)->UseRealTime();
}

}  // namespace

int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const Frame frame = synthesize(Category::complex_scene, 1, 0).frame;
  for (const std::string& config : bench::measured_configs())
    add_benchmarks(config, std::make_shared<const Levels>(config, frame));
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_levels: error: " << error.what() << '\n';
  return 1;
}
