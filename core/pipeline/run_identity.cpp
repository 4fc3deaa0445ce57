// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/run_identity.h"

#include <map>
#include <mutex>
#include <nlohmann/json.hpp>
#include <set>

#include "gestalt/core/base/digest.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt {

namespace fs = std::filesystem;
using nlohmann::json;

namespace {

/// The core's, and those of the components that the config names.
std::set<fs::path> libraries(const Config& config, const Registry& registry) {
  std::set<fs::path> files{core_library()};
  const auto add = [&](const char* kind, const ComponentConfig& component) {
    const ComponentInfo* const info = registry.find(kind, component.plugin);
    std::error_code error;
    if (info && fs::is_regular_file(info->library, error)) files.insert(info->library);
  };
  const auto add_level = [&](const LevelConfig& level) {
    for (const ComponentConfig& relation : level.relations) add("relation", relation);
    add("classifier", level.classifier);
  };
  add("clusterer", config.clusterer);
  for (const ComponentConfig& fitter : config.fitters) add("fitter", fitter);
  add_level(config.structural);
  if (config.assembly) add_level(*config.assembly);
  add("solver", config.solver);
  return files;
}

/// Of a library as it was when it was first asked for: the process goes on with what it has loaded.
std::string library_digest(const fs::path& library) {
  static std::mutex mutex;
  static std::map<fs::path, std::string> known;
  const std::lock_guard lock(mutex);
  std::string& text = known[library];
  if (text.empty()) text = file_digest(library);
  return text;
}

}  // namespace

std::string run_identity(const LoadedConfig& loaded) {
  // Where things lie is not what they are: the model and the libraries are named by their content.
  json values = loaded.tree.to_json(loaded.registry).at("values");
  for (const char* key : {"time_budget", "model", "plugin_directories"}) values.erase(key);
  std::string text = values.dump(-1, ' ', false, json::error_handler_t::replace) + '\n';
  try {
    if (!loaded.config.model.empty()) text += file_digest(loaded.config.model);
  } catch (const InputError& error) {
    throw ModelError(error.what());
  }
  for (const fs::path& library : libraries(loaded.config, loaded.registry))
    text += '\n' + library.filename().string() + ' ' + library_digest(library);
  return digest(text);
}

}  // namespace gestalt
