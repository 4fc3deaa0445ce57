// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/config.h"
#include "gestalt/error.h"
#include "gestalt/hash.h"

namespace gestalt {

std::string canonical(const ParameterValues& values) {
  std::string text;
  for (const auto& [name, value] : values) text += "  " + name + "=" + to_string(value) + "\n";
  return text;
}

namespace {

std::string component_text(const char* kind, const ComponentConfig& component) {
  return std::string(kind) + " " + component.plugin + "\n" + canonical(component.params);
}

}  // namespace

std::string config_hash(const Config& config, Level level) {
  if (level == Level::assembly && !config.assembly)
    throw ConfigError("the config has no section assembly; add it, or set levels: structural");
  const LevelConfig& own = level == Level::structural ? config.structural : *config.assembly;
  std::string text = component_text("clusterer", config.clusterer);
  for (const ComponentConfig& fitter : config.fitters) text += component_text("fitter", fitter);
  text += "model_selection\n" + canonical(config.surface_modelling);
  for (const ComponentConfig& relation : own.relations) text += component_text("relation", relation);
  text += "minimum_size " + std::to_string(own.minimum_size) + "\n";
  return content_hash(text);
}

}  // namespace gestalt
