// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cstdint>

#include "gestalt/config.h"
#include "gestalt/error.h"

namespace gestalt {

namespace {

std::string canonical(const ParameterValues& values) {
  std::string text;
  for (const auto& [name, value] : values) text += "  " + name + "=" + to_string(value) + "\n";
  return text;
}

std::string canonical(const char* kind, const ComponentConfig& component) {
  return std::string(kind) + " " + component.plugin + "\n" + canonical(component.params);
}

std::uint64_t fnv1a(const std::string& text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

}  // namespace

std::string config_hash(const Config& config, Level level) {
  if (level == Level::assembly && !config.assembly)
    throw ConfigError("the config has no section assembly; add it, or set levels: structural");
  const LevelConfig& own = level == Level::structural ? config.structural : *config.assembly;
  std::string text = canonical("clusterer", config.clusterer);
  for (const ComponentConfig& fitter : config.fitters) text += canonical("fitter", fitter);
  text += "model_selection\n" + canonical(config.surface_modelling);
  for (const ComponentConfig& relation : own.relations) text += canonical("relation", relation);
  text += "minimum_size " + std::to_string(own.minimum_size) + "\n";

  constexpr char digits[] = "0123456789abcdef";
  const std::uint64_t hash = fnv1a(text);
  std::string hexadecimal;
  for (int shift = 60; shift >= 0; shift -= 4) hexadecimal += digits[(hash >> shift) & 15];
  return hexadecimal;
}

}  // namespace gestalt
