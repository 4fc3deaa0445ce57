// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/reproduction.h"

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "experiments.h"
#include "pipeline_options.h"

namespace gestalt::app {

namespace {

struct Options {
  std::filesystem::path data;
  std::filesystem::path output;
  int folds = 5;
  PipelineOptions pipeline;
  bool json = false;
};

int reproduce(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  const Protocol protocol = find_protocol(options.data, options.folds);
  require_apart(protocol);
  const LoadedConfig loaded = load_config(options.pipeline);
  const std::vector<Variant> variants = reproduction_variants(loaded.config, loaded.registry);
  const std::vector<ExperimentOutcome> outcomes =
      run_with_progress(variants, loaded.registry, protocol, options.output / "results");
  const std::vector<NamedResult> results = named(variants, outcomes);
  const Report report = reproduction_report(protocol, results);
  write_files(report_files(report, options.output, "report"));
  if (options.json)
    std::cout << reproduction_json(results).dump(1) << '\n';
  else
    std::cout << plain_text(report);
  return exit_code(outcomes);
}

}  // namespace

void add_reproduce(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("reproduce", "Make the tables of the paper from labelled scenes");
  command
      ->add_option(
          "data", options->data,
          "Folder with the folders learn and test of scenes with ground truth, and learn.csv and test.csv with "
          "their categories; without test, or where it is a folder of scenes itself, by cross-validation")
      ->required()
      ->type_name("DATA");
  command
      ->add_option("--output", options->output,
                   "Folder for report.md, report.html, figures, and results/, which a later run takes up")
      ->check(not_empty)
      ->required()
      ->type_name("DIR");
  command->add_option("--cross-validate", options->folds, "Folds where there is no test set")
      ->check(CLI::Range(2, 1000000))
      ->capture_default_str()
      ->type_name("K");
  add_pipeline_options(*command, options->pipeline);
  command->add_flag("--json", options->json, "Print every result as JSON, for programs");
  command->footer("Example: gestalt reproduce osd --output report");
  command->callback([options, &run] { run = [options] { return reproduce(*options); }; });
}

}  // namespace gestalt::app
