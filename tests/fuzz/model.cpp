// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A model file, read for configs with each of the classifiers; what can be read must give a probability for any pair.

#include "gestalt/core/pipeline/model.h"

#include <cmath>
#include <iostream>

#include "gestalt/core/pipeline/segmenter.h"
#include "scratch.h"

namespace {

using namespace gestalt;

Pipeline pipeline_of(const std::vector<std::string>& overrides) {
  const LoadedConfig loaded(ConfigTree(default_config(), overrides));
  return Pipeline(loaded.config, loaded.registry);
}

void require_probabilities(const Model& model) {
  for (const double value : {-1e300, -1.0, 0.0, 0.25, 1e300}) {
    const double p = model.probability(std::vector<double>(model.names.size(), value));
    if (p >= 0 && p <= 1) continue;
    std::cerr << "a model gives p = " << p << '\n';
    std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const std::vector<Pipeline> pipelines = [] {
    std::vector<Pipeline> made;
    for (const char* classifier : {"committee", "random_forest", "svm"})
      made.push_back(pipeline_of({"levels=structural", std::string("structural.classifier=") + classifier}));
    return made;
  }();
  const std::filesystem::path file = scratch.write("model.json", text_of(data, size));
  for (const Pipeline& pipeline : pipelines)
    expect_result_or_error(
        [&] { require_probabilities(read_models(file, pipeline.expected_model(Level::structural), {}).structural); });
  return 0;
}
