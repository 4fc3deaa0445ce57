// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/global_control.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/core/config/config.h"
#include "gestalt/core/pipeline/pipeline.h"
#include "gestalt/core/plugin/registry.h"

namespace gestalt::app {

/// --config, --set and --threads, which several subcommands share.
struct PipelineOptions {
  std::filesystem::path config;        ///< empty: default_config()
  std::vector<std::string> overrides;  ///< path=value
  int threads = 0;                     ///< 0: as many as the machine has
};

/// default_name: of the config that the command uses when no other is asked for, for its help.
void add_pipeline_options(CLI::App& command, PipelineOptions& options,
                          const std::string& default_name = "default.yaml");

/// The config as the options ask for it, with its plugins.
struct LoadedConfig {
  ConfigTree tree;
  Registry registry;
  Config config;
};

LoadedConfig load_config(const PipelineOptions& options);

/// The pipeline's models. Warns on stderr when one was trained with other parameters of the levels below the
/// classifier.
Models load_models(const Pipeline& pipeline);

/// Bounds the threads of oneTBB and OpenCV while it lives. 0: no bound.
class ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  std::optional<tbb::global_control> limit_;
  int opencv_threads_;  ///< before
};

}  // namespace gestalt::app
