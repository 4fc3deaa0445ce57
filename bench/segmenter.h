// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/core/config/config.h"
#include "gestalt/core/pipeline/pipeline.h"

namespace gestalt::bench {

/// A config with its plugins and models, ready to run.
struct Segmenter {
  /// Throws ConfigError, PluginError, ModelError.
  explicit Segmenter(const std::filesystem::path& config = default_config());

  /// The same with other components than those of plugins.
  Segmenter(const std::filesystem::path& config, Registry components);

  /// Segments the frame, and tells the milliseconds of each level.
  LevelTimes operator()(const Frame& frame) const;

  ConfigTree tree;
  Registry registry;
  Pipeline pipeline;
  Models models;
};

/// The file of a config that comes with Gestalt, by its name without extension.
std::filesystem::path bundled_config(const std::string& name);

/// The names of the configs whose times are told: the default, the one for real time, the paper's; those of them that
/// this installation has.
std::vector<std::string> measured_configs();

}  // namespace gestalt::bench
