// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/ablation.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>

#include "command.h"
#include "gestalt/apps/depth_only.h"
#include "gestalt/apps/experiments.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::app::ablate_command {

namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<fs::path> scenes;
  std::vector<fs::path> test;
  int folds = 5;
  std::uint64_t seed = 0;
  ReadingOptions reading;
  PipelineOptions pipeline;
  fs::path variants;
  std::vector<std::string> grid;
  std::vector<std::string> each;
  std::string mode = "without";
  fs::path output;
  bool json = false;
};

fs::path config_file(const Options& options) {
  return options.pipeline.config.empty() ? default_config() : options.pipeline.config;
}

/// The base's config with further overrides.
Variant overridden(const Options& options, const Registry& registry, const OverrideSet& set) {
  std::vector<std::string> overrides = options.pipeline.overrides;
  overrides.insert(overrides.end(), set.overrides.begin(), set.overrides.end());
  try {
    return {set.name, ConfigTree(config_file(options), overrides).resolve(registry)};
  } catch (const ConfigError& error) {
    throw ConfigError("variant '" + set.name + "': " + error.what());
  }
}

std::vector<Variant> all_variants(const Options& options, const LoadedConfig& loaded) {
  std::vector<Variant> variants{{"base", loaded.config}};
  std::vector<OverrideSet> sets = grid(options.grid);
  if (!options.variants.empty()) {
    const std::vector<OverrideSet> named = read_override_sets(options.variants);
    sets.insert(sets.begin(), named.begin(), named.end());
  }
  for (const OverrideSet& set : sets) variants.push_back(overridden(options, loaded.registry, set));
  const EachMode mode = options.mode == "only" ? EachMode::only : EachMode::without;
  for (const std::string& target : options.each) {
    const std::vector<Variant> more = each(variants.front(), loaded.registry, target, mode);
    variants.insert(variants.end(), more.begin(), more.end());
  }
  std::set<std::string> names;
  for (const Variant& variant : variants)
    if (!names.insert(variant.name).second)
      throw ConfigError("two variants are named '" + variant.name + "'; rename one ('base' is the config itself)");
  if (variants.size() == 1) throw ConfigError("there is nothing to compare; give --variants, --grid or --each");
  return variants;
}

nlohmann::ordered_json results_json(const std::vector<NamedResult>& results) {
  nlohmann::ordered_json json;
  for (const auto& [name, result] : results)
    json["variants"][name] = result ? to_json(*result) : nlohmann::ordered_json(nullptr);
  return json;
}

int ablate(Options options) {
  const ThreadLimit limit(options.pipeline.threads);
  Protocol protocol;
  protocol.learn = find_scenes(options.scenes);
  if (!options.test.empty()) protocol.test = find_scenes(options.test);
  protocol.folds = options.folds;
  protocol.seed = options.seed;
  protocol.read = read_options(options.reading);
  require_apart(protocol);
  options.pipeline = options_for_all(options.pipeline, protocol.learn, protocol.read);

  const LoadedConfig loaded = load_config(options.pipeline);
  const std::vector<Variant> variants = all_variants(options, loaded);
  const std::vector<ExperimentOutcome> outcomes =
      run_with_progress(variants, loaded.registry, protocol, OutputPath(options.output) / "results");
  const std::vector<NamedResult> results = named(variants, outcomes);
  const Report report =
      ablation_report("Ablation of " + config_file(options).filename().string(), description(protocol), results);
  std::vector<OutputFile> files = report_files(report, options.output, "ablation");
  files.push_back({OutputPath(options.output) / "ablation.csv", csv(ablation_rows(results))});
  write_files(files);
  if (options.json)
    std::cout << results_json(results).dump(1) << '\n';
  else
    std::cout << plain_text(report);
  return exit_code(outcomes);
}

void add_ablate(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("ablate", "Train and evaluate many variants of a config and compare them");
  command
      ->add_option("scenes", options->scenes,
                   "Scenes with ground truth, or folders of them; FOLDER.csv beside a folder gives categories")
      ->required()
      ->type_name("SCENES");
  add_reading_options(*command, options->reading);
  add_pipeline_options(*command, options->pipeline);
  command
      ->add_option("--variants", options->variants,
                   "YAML file of named lists of overrides: 'small patches: [structural.minimum_size=20]'")
      ->type_name("FILE");
  command
      ->add_option("--grid", options->grid,
                   "Values of a config path; given several times, every combination of them is a variant")
      ->type_name("PATH=V1,V2,...")
      ->expected(1)
      ->take_all();
  CLI::Option* each_option = command
                                 ->add_option("--each", options->each,
                                              "A variant for each of structural.relations, structural.values (single "
                                              "relation values), assembly.relations or assembly.values")
                                 ->type_name("LIST")
                                 ->expected(1)
                                 ->take_all();
  command->add_option("--mode", options->mode, "With --each: without it (the default), or only it")
      ->check(CLI::IsMember({"only", "without"}))
      ->needs(each_option);
  CLI::Option* folds = command
                           ->add_option("--cross-validate", options->folds,
                                        "Evaluate each of K folds of the scenes with a model trained on the others")
                           ->check(number_in(2, 1000000))
                           ->capture_default_str()
                           ->type_name("K");
  command
      ->add_option("--seed", options->seed,
                   "Seed of the random order in which scenes are assigned to folds; 0: natural order")
      ->check(seed_number())
      ->type_name("S");
  command->add_option("--test", options->test, "Train on SCENES and evaluate on these instead of cross-validation")
      ->excludes(folds)
      ->type_name("SCENES");
  command
      ->add_option("--output", options->output,
                   "Folder for ablation.csv, .md and .html, plots, and results/, which later runs reuse")
      ->required()
      ->type_name("DIR");
  command->add_flag("--json", options->json, "Print every result as JSON, for programs");
  command->footer(
      "Example: gestalt ablate scenes --each structural.relations --output ablation\n"
      "         gestalt ablate learn --test test --grid structural.minimum_size=20,30,60 --output sizes");
  command->callback([options, &run] { run = [options] { return ablate(*options); }; });
}

const Subcommand subcommand(50, add_ablate);

}  // namespace

}  // namespace gestalt::app::ablate_command
