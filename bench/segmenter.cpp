// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "segmenter.h"

namespace gestalt::bench {

Segmenter::Segmenter(const std::filesystem::path& config)
    : tree(config, {}),
      registry(plugin_search_path(tree.plugin_directories())),
      pipeline(tree.resolve(registry), registry),
      models(pipeline.load_models()) {}

Segmenter::Segmenter(const std::filesystem::path& config, Registry components)
    : tree(config, {}),
      registry(std::move(components)),
      pipeline(tree.resolve(registry), registry),
      models(pipeline.load_models()) {}

LevelTimes Segmenter::operator()(const Frame& frame) const {
  const Percept percept = pipeline.perceive(frame);
  LevelTimes times = percept.times;
  pipeline.decide(percept, models, &times);
  return times;
}

std::filesystem::path bundled_config(const std::string& name) {
  return data_directory() / "configs" / (name + ".yaml");
}

std::vector<std::string> measured_configs() {
  std::vector<std::string> names;
  for (const char* name : {"default", "realtime", "paper"})
    if (std::filesystem::exists(bundled_config(name))) names.emplace_back(name);
  return names;
}

}  // namespace gestalt::bench
