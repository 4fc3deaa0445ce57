// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gestalt/config.h"
#include "gestalt/pipeline.h"
#include "gestalt/registry.h"

namespace gestalt::app {

/// --config, --set and --threads, which several subcommands share.
struct PipelineOptions {
  std::filesystem::path config;        ///< empty: default_config()
  std::vector<std::string> overrides;  ///< path=value
  int threads = 0;                     ///< 0: as many as the machine has
};

void add_pipeline_options(CLI::App& command, PipelineOptions& options);

/// The config as the options ask for it, with its plugins.
struct LoadedConfig {
  ConfigTree tree;
  Registry registry;
  Config config;
};

LoadedConfig load_config(const PipelineOptions& options);

}  // namespace gestalt::app
