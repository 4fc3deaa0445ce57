// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pipeline_options.h"

#include <algorithm>
#include <iostream>

#include "gestalt/apps/number_in.h"
#include "gestalt/core/config/sensor_params.h"

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
      ->check(number_in(0, 1024));
}

void add_shorthands(CLI::App& command, PipelineOptions& options) {
  const auto add = [&](const std::string& name, const std::string& path, const std::string& text) {
    return command.add_option_function<std::string>(
        name, [&options, path](const std::string& value) { options.shorthands.push_back(path + "=" + value); },
        text + "; short for --set " + path);
  };
  const std::vector<Parameter>& sensor = SensorParams::parameters().declarations();
  const auto noise =
      std::find_if(sensor.begin(), sensor.end(), [](const Parameter& parameter) { return parameter.name == "noise"; });
  add("--sensor", "sensor.noise", "The sensor that made the frames")
      ->check(CLI::IsMember(noise->choices))
      ->type_name("NAME");
  add("--max-depth", "decision.figure_ground.max_depth",
      "Treat everything farther away than this many metres as background; 0: off")
      ->check(number_in(0.0, 1000.0))
      ->type_name("M");
  add("--min-object", "decision.figure_ground.min_object",
      "Treat segments with a visible area below this many square centimetres as background")
      ->check(number_in(0.0, 1e6))
      ->type_name("CM2");
}

LoadedConfig load_config(const PipelineOptions& options) {
  std::vector<std::string> overrides = options.shorthands;
  overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
  return LoadedConfig(ConfigTree(options.config.empty() ? default_config() : options.config, overrides));
}

Segmenter load_segmenter(LoadedConfig loaded) {
  Segmenter segmenter(std::move(loaded));
  if (const std::string warning = segmenter.warning(); !warning.empty())
    std::cerr << "gestalt: warning: " << warning << '\n';
  return segmenter;
}

Segmenter load_segmenter(const PipelineOptions& options) { return load_segmenter(load_config(options)); }

}  // namespace gestalt::app
