// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pipeline_options.h"

#include <iostream>
#include <opencv2/core/utility.hpp>

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
  ConfigTree tree(options.config.empty() ? default_config() : options.config, options.overrides);
  Registry registry(plugin_search_path(tree.plugin_directories()));
  Config config = tree.resolve(registry);
  return {std::move(tree), std::move(registry), std::move(config)};
}

Models load_models(const Pipeline& pipeline) {
  Models models = pipeline.load_models();
  if (pipeline.trained_otherwise(models))
    std::cerr << "gestalt: warning: " << pipeline.config().model.string()
              << " was trained with other parameters of the levels below the classifier; retrain it for this config\n";
  return models;
}

ThreadLimit::ThreadLimit(int threads) : opencv_threads_(cv::getNumThreads()) {
  if (threads == 0) return;
  limit_.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  cv::setNumThreads(threads);
}

ThreadLimit::~ThreadLimit() { cv::setNumThreads(opencv_threads_); }

}  // namespace gestalt::app
