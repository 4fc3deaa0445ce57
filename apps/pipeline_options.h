// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "gestalt/core/base/thread_limit.h"
#include "gestalt/core/pipeline/segmenter.h"

namespace gestalt::app {

/// --config, --set and --threads, which several subcommands share.
struct PipelineOptions {
  std::filesystem::path config;         ///< empty: default_config()
  std::vector<std::string> shorthands;  ///< path=value, from options of their own; overrides come after them
  std::vector<std::string> overrides;   ///< path=value
  int threads = 0;                      ///< 0: as many as the machine has
};

/// default_name: of the config that the command uses when no other is asked for, for its help.
void add_pipeline_options(CLI::App& command, PipelineOptions& options,
                          const std::string& default_name = "default.yaml");

/// --sensor, --max-depth and --min-object: what a user knows of his frames, in words of its own instead of --set.
void add_shorthands(CLI::App& command, PipelineOptions& options);

/// The config that the options ask for.
LoadedConfig load_config(const PipelineOptions& options);

/// The segmenter of a config; prints its warning on stderr.
Segmenter load_segmenter(LoadedConfig loaded);
Segmenter load_segmenter(const PipelineOptions& options);

}  // namespace gestalt::app
