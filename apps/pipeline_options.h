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

#include "gestalt/core/pipeline/segmenter.h"

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

/// The config that the options ask for.
LoadedConfig load_config(const PipelineOptions& options);

/// The segmenter of a config; prints its warning on stderr.
Segmenter load_segmenter(LoadedConfig loaded);
Segmenter load_segmenter(const PipelineOptions& options);

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
