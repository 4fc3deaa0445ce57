// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Arbitrary small images through the whole pipeline, with arbitrary components and values of their parameters within
// the ranges that they declare; what comes out must be finite, in its range and consistent.

#include "gestalt/core/pipeline/pipeline.h"

#include <fuzzer/FuzzedDataProvider.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <limits>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/figure_ground.h"
#include "gestalt/core/pipeline/learning_set.h"

namespace {

using namespace gestalt;

[[noreturn]] void found(const std::string& what) {
  std::cerr << what << '\n';
  std::abort();
}

double number_in(FuzzedDataProvider& provider, double low, double high) {
  low = std::max(low, -1e6);
  high = std::min(high, 1e6);
  switch (provider.ConsumeIntegralInRange(0, 3)) {
    case 0:
      return low;
    case 1:
      return high;
    default:
      return provider.ConsumeFloatingPointInRange(low, high);
  }
}

ParameterValue any_value(FuzzedDataProvider& provider, const Parameter& parameter) {
  switch (parameter.type) {
    case Parameter::Type::boolean:
      return provider.ConsumeBool();
    case Parameter::Type::choice:
      return parameter.choices[provider.ConsumeIntegralInRange<std::size_t>(0, parameter.choices.size() - 1)];
    case Parameter::Type::integer:
      return std::int64_t(std::floor(number_in(provider, parameter.minimum, parameter.maximum)));
    default:
      return number_in(provider, parameter.minimum, parameter.maximum);
  }
}

/// Changes one in four values.
void change(FuzzedDataProvider& provider, const std::vector<Parameter>& parameters, ParameterValues& values) {
  for (const Parameter& parameter : parameters)
    if (provider.ConsumeIntegralInRange(0, 3) == 0) values[parameter.name] = any_value(provider, parameter);
}

class AnyConfig {
 public:
  AnyConfig(FuzzedDataProvider& provider, const Registry& registry) : provider_(provider), registry_(registry) {}

  Config operator()(Config config) {
    config.clusterer = any_component("clusterer");
    for (ComponentConfig& fitter : config.fitters) change_params("fitter", fitter);
    change(provider_, SurfaceModellingParams::parameters().declarations(), config.surface_modelling);
    change_level(config.structural);
    change_level(*config.assembly);
    config.with_assembly = provider_.ConsumeBool();
    config.solver = any_component("solver");
    change(provider_, FigureGroundParams::parameters().declarations(), config.figure_ground);
    return config;
  }

 private:
  void change_params(const std::string& kind, ComponentConfig& component) {
    change(provider_, registry_.parameters(kind, component.plugin), component.params);
  }

  ComponentConfig any_component(const std::string& kind) {
    const std::vector<std::string> names = registry_.names(kind);
    const std::string& name = names[provider_.ConsumeIntegralInRange<std::size_t>(0, names.size() - 1)];
    ComponentConfig component{name, name, complete(registry_.parameters(kind, name), {})};
    change_params(kind, component);
    return component;
  }

  void change_level(LevelConfig& level) {
    level.minimum_size = provider_.ConsumeIntegralInRange(0, 60);
    for (ComponentConfig& relation : level.relations) change_params("relation", relation);
  }

  FuzzedDataProvider& provider_;
  const Registry& registry_;
};

constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();

/// Depth of slanted planes, each in a rectangle, with noise and what a driver should never give.
cv::Mat_<float> any_depth(FuzzedDataProvider& provider, cv::Size size) {
  cv::Mat_<float> depth(size, provider.PickValueInArray({0.0F, 0.5F, 1.0F, 3.0F, 1e-40F, 1e30F, inf, nan, -1.0F}));
  for (int plane = provider.ConsumeIntegralInRange(0, 6); plane > 0; --plane) {
    const int left = provider.ConsumeIntegralInRange(0, size.width - 1),
              top = provider.ConsumeIntegralInRange(0, size.height - 1);
    const int right = provider.ConsumeIntegralInRange(left, size.width - 1),
              bottom = provider.ConsumeIntegralInRange(top, size.height - 1);
    const float base = provider.ConsumeFloatingPointInRange(0.2F, 4.0F);
    const float across = provider.ConsumeFloatingPointInRange(-0.1F, 0.1F),
                down = provider.ConsumeFloatingPointInRange(-0.1F, 0.1F);
    const float bend = provider.ConsumeFloatingPointInRange(-0.01F, 0.01F);
    for (int v = top; v <= bottom; ++v)
      for (int u = left; u <= right; ++u) {
        const auto x = float(u - left), y = float(v - top);
        depth(v, u) = base + across * x + down * y + bend * x * x;
      }
  }
  for (int pixel = provider.ConsumeIntegralInRange(0, 20); pixel > 0; --pixel)
    depth(provider.ConsumeIntegralInRange(0, size.height - 1), provider.ConsumeIntegralInRange(0, size.width - 1)) =
        provider.PickValueInArray({0.0F, 1e-40F, 1e30F, inf, -inf, nan, -1.0F, 0.7F});
  return depth;
}

cv::Mat any_colour(FuzzedDataProvider& provider, cv::Size size) {
  cv::Mat colour(size, CV_8UC3);
  std::uint32_t state = provider.ConsumeIntegral<std::uint32_t>();
  const int step = provider.ConsumeIntegralInRange(1, 8);
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      if ((u + v) % step == 0) state = state * 1664525U + 1013904223U;
      colour.at<cv::Vec3b>(v, u) = {std::uint8_t(state >> 24), std::uint8_t(state >> 16), std::uint8_t(state >> 8)};
    }
  return colour;
}

cv::Mat_<std::uint16_t> any_ground_truth(FuzzedDataProvider& provider, cv::Size size) {
  cv::Mat_<std::uint16_t> labels(size, std::uint16_t(1));
  for (int object = 0; object < 3; ++object) {
    const int left = provider.ConsumeIntegralInRange(0, size.width - 1),
              top = provider.ConsumeIntegralInRange(0, size.height - 1);
    labels(cv::Rect(left, top, std::min(8, size.width - left), std::min(8, size.height - top))).setTo(20 + 10 * object);
  }
  return labels;
}

void require_finite(const RelationTable& table) {
  for (const double value : table.values)
    if (!std::isfinite(value)) found("a relation's value is " + std::to_string(value));
}

void require_consistent(const Percept& percept, const Segmentation& segmentation, cv::Size size) {
  if (segmentation.labels.size() != size) found("labels are of another size");
  for (const Edge& edge : segmentation.graph.edges)
    if (!(edge.probability >= 0 && edge.probability <= 1)) found("p is " + std::to_string(edge.probability));
  std::vector<int> times(percept.surfaces().surfaces.size());
  for (const Segment& segment : segmentation.segments)
    for (const int surface : segment.surfaces) ++times.at(std::size_t(surface));
  if (std::any_of(times.begin(), times.end(), [](int n) { return n != 1; }))
    found("a surface is not in exactly one segment");
  double highest = 0;
  cv::minMaxLoc(segmentation.labels, nullptr, &highest);
  if (highest > double(segmentation.segments.size())) found("a label without a segment");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Registry registry(plugin_search_path({}));
  static const Config base =
      ConfigTree(default_config(), {"structural.classifier=random_forest", "structural.classifier.params.trees=4"})
          .resolve(registry);
  FuzzedDataProvider provider(data, size);
  const cv::Size image(provider.ConsumeIntegralInRange(1, 20), provider.ConsumeIntegralInRange(1, 16));
  // A PluginError would be a fault of our plugins.
  try {
    const Pipeline pipeline(AnyConfig(provider, registry)(base), registry);
    const double focal = provider.PickValueInArray({1.0, 40.0, 525.0});
    const Camera camera{image.width, image.height, focal, focal, image.width / 2.0, image.height / 2.0};
    const Frame frame = make_frame("fuzzed", any_colour(provider, image), any_depth(provider, image), camera);
    const LearningScene scene = make_learning_scene(pipeline, frame, any_ground_truth(provider, image));
    require_finite(scene.percept.structural);
    require_finite(scene.percept.assembly);
    const Models models = learn(pipeline, {&scene});
    require_consistent(scene.percept, pipeline.decide(scene.percept, models), image);
  } catch (const ConfigError&) {
  } catch (const InputError&) {
  } catch (const ModelError&) {
  }
  return 0;
}
