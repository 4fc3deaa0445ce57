// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Models, results and cameras of BOP that are sound JSON with some of their values exchanged, repeated or left out:
// what bytes alone seldom reach, as most of their changes end at the parser.

#include <fuzzer/FuzzedDataProvider.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "gestalt/core/pipeline/segmenter.h"
#include "gestalt/io/dataset/bop_scene.h"
#include "gestalt/io/result/result_file.h"
#include "scratch.h"

namespace {

using namespace gestalt;
using nlohmann::json;

json seed(const char* name) {
  std::ifstream in(std::string(FUZZ_CORPUS) + "/" + name);
  return json::parse(in);
}

json odd_value(FuzzedDataProvider& provider) {
  switch (provider.ConsumeIntegralInRange(0, 9)) {
    case 0:
      return nullptr;
    case 1:
      return provider.ConsumeBool();
    case 2:
      return provider.ConsumeIntegral<std::int64_t>();
    case 3:
      return provider.PickValueInArray<std::int64_t>({-1, 0, 1, 2, 65535, 65536, 2147483647, -2147483648LL, 1LL << 53});
    case 4:
      return provider.PickValueInArray({0.0, -0.0, 1e-320, 0.5, 1e308, -1e308, 1e17});
    case 5:
      return std::uint64_t(-1);
    case 6:
      return provider.ConsumeRandomLengthString(40);
    case 7:
      return json::array();
    case 8:
      return json::object();
    default:
      return json(provider.ConsumeIntegralInRange<std::size_t>(0, 5000), 0);
  }
}

/// A value some levels below.
json& any_value(FuzzedDataProvider& provider, json& root) {
  json* value = &root;
  for (int level = provider.ConsumeIntegralInRange(1, 10); level > 0 && value->is_structured() && !value->empty();
       --level)
    value = &*std::next(value->begin(),
                        provider.ConsumeIntegralInRange<std::ptrdiff_t>(0, std::ptrdiff_t(value->size()) - 1));
  return *value;
}

void edit(FuzzedDataProvider& provider, json& root) {
  json& value = any_value(provider, root);
  switch (provider.ConsumeIntegralInRange(0, 4)) {
    case 0:
      if (value.is_structured() && !value.empty()) value.erase(value.begin());
      break;
    case 1: {  // a number of copies of what an array begins with
      if (!value.is_array() || value.empty()) break;
      const json first = value[0];
      for (int copy = provider.ConsumeIntegralInRange(1, 2000); copy > 0 && value.size() < 20000; --copy)
        value.push_back(first);
      break;
    }
    case 2: {  // what stands elsewhere; from the copy, as one may contain the other
      json whole = root;
      value = any_value(provider, whole);
      break;
    }
    default:
      value = odd_value(provider);
  }
}

std::string edited(FuzzedDataProvider& provider, json content) {
  for (int edits = provider.ConsumeIntegralInRange(0, 8); edits > 0; --edits) edit(provider, content);
  return content.dump(-1, ' ', false, json::error_handler_t::replace);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const json forest = seed("model/random_forest"), svm = seed("model/svm"), tiny = seed("result/tiny"),
                    bspline = seed("result/bspline"), camera = seed("bop/camera");
  static const std::vector<Pipeline> pipelines = [] {
    scratch.write("bop/depth/000001.png", "");
    std::vector<Pipeline> made;
    for (const char* classifier : {"random_forest", "svm"}) {
      const LoadedConfig loaded(
          ConfigTree(default_config(), {"levels=structural", std::string("structural.classifier=") + classifier}));
      made.emplace_back(loaded.config, loaded.registry);
    }
    return made;
  }();
  FuzzedDataProvider provider(data, size);
  const int kind = provider.ConsumeIntegralInRange(0, 4);
  if (kind < 2) {
    const Pipeline& pipeline = pipelines[std::size_t(kind)];
    const auto file = scratch.write("model.json", edited(provider, kind == 0 ? forest : svm));
    return expect_result_or_error([&] {
      const Model model = read_models(file, pipeline.expected_model(Level::structural), {}).structural;
      const double p = model.probability(std::vector<double>(model.names.size(), 0.5));
      if (!(p >= 0 && p <= 1)) std::abort();
    });
  }
  if (kind < 4) {
    const auto file = scratch.write("result.json", edited(provider, kind == 2 ? tiny : bspline));
    return expect_result_or_error([&] {
      const StoredResult result = read_result(file);
      TriangulationBudget budget;
      for (const StoredResult::Segment& segment : result.segments)
        expect_result_or_error([&] { triangulate(result, segment, 0.001, budget); });
    });
  }
  const auto file = scratch.write("bop/scene_camera.json", edited(provider, camera));
  return expect_result_or_error([&] {
    for (const BopImage& image : find_bop_images(file.parent_path()))
      expect_result_or_error([&] { read_bop_image(image); });
  });
}
