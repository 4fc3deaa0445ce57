// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Every relation of every plugin that the registry finds, with its default parameters, on the surfaces of one synthetic
// scene: <name>/bind is what it computes of the scene, shared products of the scene included; <name>/pairs is what it
// then computes of all pairs that it knows, items are pairs.

#include <benchmark/benchmark.h>

#include <iostream>

#include "configs.h"
#include "gestalt/synthesis/synthesis.h"

namespace {

using namespace gestalt;

struct Surfaces {
  Percept percept;
  std::vector<SurfacePair> neighbours;
  std::vector<SurfacePair> all_pairs;
};

Surfaces perceive(const Pipeline& pipeline) {
  Surfaces result{pipeline.perceive(synthesize(Category::complex_scene, 1, 0).frame), {}, {}};
  result.neighbours = neighbour_pairs(result.percept.surfaces(), 0);
  result.all_pairs = non_neighbour_pairs(result.percept.surfaces(), 0);
  result.all_pairs.insert(result.all_pairs.end(), result.neighbours.begin(), result.neighbours.end());
  return result;
}

void bind(benchmark::State& state, const Relation& relation, const Surfaces& surfaces) {
  for (auto _ : state) {
    state.PauseTiming();
    const Scene scene(surfaces.percept.frame(), surfaces.percept.patches(), surfaces.percept.surfaces());
    state.ResumeTiming();
    benchmark::DoNotOptimize(relation.bind(scene));
  }
}

void measure_pairs(benchmark::State& state, const Relation& relation, const Surfaces& surfaces) {
  const Scene& scene = *surfaces.percept.scene;
  const std::unique_ptr<Measure> measure = relation.bind(scene);
  const std::vector<SurfacePair>& pairs = relation.needs_border() ? surfaces.neighbours : surfaces.all_pairs;
  std::vector<double> values(relation.values().size());
  for (auto _ : state)
    for (const SurfacePair& pair : pairs) {
      (*measure)(pair, values);
      benchmark::DoNotOptimize(values.data());
    }
  state.SetItemsProcessed(state.iterations() * std::int64_t(pairs.size()));
}

}  // namespace

int main(int argc, char** argv) try {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  const Segmenter segmenter;
  const Surfaces surfaces = perceive(segmenter.pipeline());
  for (const std::string& name : segmenter.registry().names("relation")) {
    const auto relation = segmenter.registry().create<Relation>(name, {});
    benchmark::RegisterBenchmark((name + "/bind").c_str(),
                                 [relation, &surfaces](auto& state) { bind(state, *relation, surfaces); })
        ->Unit(benchmark::kMicrosecond)
        ->UseRealTime();
    benchmark::RegisterBenchmark((name + "/pairs").c_str(),
                                 [relation, &surfaces](auto& state) { measure_pairs(state, *relation, surfaces); })
        ->Unit(benchmark::kMicrosecond)
        ->UseRealTime();
  }
  benchmark::RunSpecifiedBenchmarks();
  return 0;
} catch (const std::exception& error) {
  std::cerr << "bench_relations: error: " << error.what() << '\n';
  return 1;
}
