// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pipeline_options.h"

#include <iostream>

namespace gestalt::app {

void add_pipeline_options(CLI::App& command, PipelineOptions& options, const std::string& default_name) {
  command
      .add_option("--config", options.config,
                  "Config file, or the name of an installed one (default: " + default_name + ")")
      ->type_name("FILE");
  command
      .add_option("--set", options.overrides,
                  "Override a value of the config: structural.minimum_size=50, or structural.relations.gabor=off to "
                  "take a component out of a list")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all();
  command.add_option("--threads", options.threads, "Threads to use, 0 for all; the result is the same for any number")
      ->check(CLI::Range(0, 1024));
}

LoadedConfig load_config(const PipelineOptions& options) {
  return LoadedConfig(ConfigTree(options.config.empty() ? default_config() : options.config, options.overrides));
}

Segmenter load_segmenter(LoadedConfig loaded) {
  Segmenter segmenter(std::move(loaded));
  if (const std::string warning = segmenter.warning(); !warning.empty())
    std::cerr << "gestalt: warning: " << warning << '\n';
  return segmenter;
}

Segmenter load_segmenter(const PipelineOptions& options) { return load_segmenter(load_config(options)); }

}  // namespace gestalt::app
