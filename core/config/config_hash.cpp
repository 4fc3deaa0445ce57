// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>

#include "gestalt/core/base/error.h"
#include "gestalt/core/config/config.h"

namespace gestalt {

namespace {

std::string values_text(const ParameterValues& values) {
  std::string text;
  for (const auto& [name, value] : values) text += "  " + name + "=" + to_string(value) + "\n";
  return text;
}

std::string component_text(const std::string& kind, const ComponentConfig& component) {
  std::string text = kind + " " + component.plugin + "\n" + values_text(component.params);
  for (const std::string& value : component.values) text += "  only " + value + "\n";
  return text;
}

std::string primitive_text(const Config& config) {
  std::string text = component_text("clusterer", config.clusterer);
  for (const ComponentConfig& fitter : config.fitters) text += component_text("fitter", fitter);
  return text + "model_selection\n" + values_text(config.surface_modelling);
}

std::string level_text(Level name, const LevelConfig& level) {
  std::string text = std::string(name_of(name)) + "\n" + component_text("classifier", level.classifier);
  for (const ComponentConfig& relation : level.relations)
    text += component_text("relation " + relation.name, relation);  // its values are named after it
  return text + "minimum_size " + std::to_string(level.minimum_size) + "\nnegatives " +
         std::to_string(level.negatives) + "\n";
}

/// Not digest(): models hold it.
std::string fnv_1a(std::string_view text) {
  std::uint64_t state = 0xcbf29ce484222325u;
  for (const char c : text) state = (state ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  constexpr char digits[] = "0123456789abcdef";
  std::string hexadecimal;
  for (int shift = 60; shift >= 0; shift -= 4) hexadecimal += digits[(state >> shift) & 15];
  return hexadecimal;
}

}  // namespace

std::string canonical_surfaces(const Config& config) {
  return "sensor\n" + values_text(config.sensor) + "working_resolution " + std::to_string(config.working_resolution) +
         "\n" + primitive_text(config) + "figure_ground\n" + values_text(config.figure_ground);
}

std::string canonical(const Config& config) {
  return canonical_surfaces(config) + level_text(Level::structural, config.structural) +
         (config.with_assembly ? level_text(Level::assembly, config.assembly.value()) : "") +
         component_text("solver", config.solver);
}

std::string config_hash(const Config& config, Level level) {
  if (level == Level::assembly && !config.assembly)
    throw ConfigError("the config has no section assembly; add it, or set levels: structural");
  const LevelConfig& own = level == Level::structural ? config.structural : *config.assembly;
  std::string text = primitive_text(config);
  for (const ComponentConfig& relation : own.relations) text += component_text("relation", relation);
  text += "minimum_size " + std::to_string(own.minimum_size) + "\n";
  return fnv_1a(text);
}

}  // namespace gestalt
