// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/config.h"

#include <iostream>
#include <nlohmann/json.hpp>

#include "command.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/core/config/config_schema.h"

namespace gestalt::app::config_command {

namespace {

struct Options {
  PipelineOptions pipeline;
  bool json = false;
};

void add_options(CLI::App& command, PipelineOptions& options) {
  command
      .add_option("file,--config", options.config,
                  "Config file, or the name of an installed one (default: default.yaml)")
      ->type_name("FILE");
  command
      .add_option("--set", options.overrides,
                  "Override a value of the config: structural.minimum_size=50, structural.relations.gabor=off")
      ->type_name("PATH=VALUE")
      ->expected(1)
      ->take_all();
}

int check(const Options& options) {
  const LoadedConfig loaded = load_config(options.pipeline);
  const Pipeline pipeline(loaded.config, loaded.registry);  // what only shows when the components are made
  const std::filesystem::path file = options.pipeline.config.empty() ? default_config() : options.pipeline.config;
  const auto tell = [&](Level level, const LevelConfig& config) {
    std::cout << ", " << config.relations.size() << ' ' << name_of(level) << " relations, values "
              << config_hash(loaded.config, level);
  };
  std::cout << file.string() << ": valid";
  tell(Level::structural, loaded.config.structural);
  if (loaded.config.with_assembly) tell(Level::assembly, *loaded.config.assembly);
  std::cout << '\n';
  return success;
}

int print(const Options& options) {
  const LoadedConfig loaded = load_config(options.pipeline);
  if (options.json)
    std::cout << loaded.tree.to_json(loaded.registry).dump(2) << '\n';
  else
    std::cout << loaded.tree.print(loaded.registry);
  return success;
}

/// Of the installed plugins, and those that a config's plugin_directories have besides.
int schema(const Options& options) {
  std::vector<std::filesystem::path> directories;
  if (!options.pipeline.config.empty()) directories = ConfigTree(options.pipeline.config, {}).plugin_directories();
  std::cout << config_schema(Registry(plugin_search_path(directories))).dump(1) << '\n';
  return success;
}

void add_config(CLI::App& app, Run& run) {
  auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("config", "Check a config, print it resolved, or print the schema of all");
  command->require_subcommand(1);
  command->footer("Example: gestalt config check my_config.yaml");

  CLI::App* check_command =
      command->add_subcommand("check", "Report every error in a config; exit code 2 if there are any");
  add_options(*check_command, options->pipeline);
  check_command->footer("Example: gestalt config check my_config.yaml");
  check_command->callback([options, &run] { run = [options] { return check(*options); }; });

  CLI::App* print_command =
      command->add_subcommand("print", "Print the config with all values, and where each came from");
  add_options(*print_command, options->pipeline);
  print_command->footer("Example: gestalt config print --set decision.solver=graph_cut");
  print_command->add_flag("--json", options->json, "Print as JSON");
  print_command->callback([options, &run] { run = [options] { return print(*options); }; });

  CLI::App* schema_command =
      command->add_subcommand("schema", "Print the JSON schema of configs, for completion and checks in editors");
  schema_command
      ->add_option("file,--config", options->pipeline.config, "Also search the plugin_directories of this config")
      ->type_name("FILE");
  schema_command->footer("Example: gestalt config schema > config.schema.json");
  schema_command->callback([options, &run] { run = [options] { return schema(*options); }; });
}

const Subcommand subcommand(110, add_config);

}  // namespace

}  // namespace gestalt::app::config_command
