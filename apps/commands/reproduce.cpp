// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/reproduction.h"

#include <algorithm>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "command.h"
#include "gestalt/apps/experiments.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/evaluation/score/scene_sets.h"
#include "gestalt/io/scene/input.h"

namespace gestalt::app::reproduce_command {

namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path data;
  fs::path output;
  int folds = 5;
  std::vector<std::string> peers;    ///< NAME=DIR
  std::vector<std::string> further;  ///< NAME=SCENES
  PipelineOptions pipeline;
  bool json = false;
};

fs::path paper_config() { return default_config().parent_path() / "paper.yaml"; }

/// NAME and PATH of NAME=PATH, of an option. Throws ConfigError for anything else, and for a name that is known.
std::pair<std::string, fs::path> named_path(const std::string& option, const std::string& text,
                                            std::vector<std::string>& known) {
  const std::size_t equals = text.find('=');
  if (equals == std::string::npos || equals == 0 || equals + 1 == text.size())
    throw ConfigError(option + " " + text + ": must be NAME=PATH, such as " + option + " LCCP=labels");
  const std::string name = text.substr(0, equals);
  if (std::find(known.begin(), known.end(), name) != known.end())
    throw ConfigError(option + " " + text + ": the name " + name + " is taken; use another");
  known.push_back(name);
  return {name, text.substr(equals + 1)};
}

Protocol protocol_of(const Options& options) {
  Protocol protocol = find_protocol(options.data, options.folds);
  std::vector<std::string> known{"all"};
  for (const std::string& category : scene_categories(protocol.test.empty() ? protocol.learn : protocol.test))
    known.push_back(category);
  for (const std::string& text : options.further) {
    const auto [name, path] = named_path("--also-test", text, known);
    protocol.further.push_back({name, find_scenes({path})});
  }
  require_apart(protocol);
  return protocol;
}

bool is_papers(const Config& config, const Registry& registry) {
  return canonical(config) == canonical(ConfigTree(paper_config(), {}).resolve(registry));
}

int reproduce(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  const Protocol protocol = protocol_of(options);
  std::vector<PeerScores> peers;
  std::vector<std::string> peer_names;
  for (const std::string& text : options.peers) {
    const auto [name, folder] = named_path("--peer", text, peer_names);
    peers.push_back(score_peer({name, folder}, protocol));
  }
  PipelineOptions pipeline = options.pipeline;
  if (pipeline.config.empty()) pipeline.config = paper_config();
  const LoadedConfig loaded = load_config(pipeline);
  const std::vector<Variant> variants = reproduction_variants(loaded.config, loaded.registry);
  const std::vector<ExperimentOutcome> outcomes =
      run_with_progress(variants, loaded.registry, protocol, OutputPath(options.output) / "results");
  const Reproduction reproduction{protocol, named(variants, outcomes), std::move(peers),
                                  is_papers(loaded.config, loaded.registry)};
  const Report report = reproduction_report(reproduction);
  write_files(report_files(report, options.output, "report"));
  if (options.json)
    std::cout << reproduction_json(reproduction).dump(1) << '\n';
  else
    std::cout << plain_text(report);
  return exit_code(outcomes);
}

void add_reproduce(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand(
      "reproduce",
      "Reproduce the paper's tables from labelled scenes, with configs/paper.yaml unless --config is given");
  command
      ->add_option(
          "data", options->data,
          "Folder with the folders learn and test of scenes with ground truth, and learn.csv and test.csv with "
          "their categories; without test, or where it is a folder of scenes itself, by cross-validation")
      ->required()
      ->type_name("DATA");
  command
      ->add_option("--output", options->output,
                   "Folder for report.md, report.html, figures, and results/, which later runs reuse")
      ->required()
      ->type_name("DIR");
  command->add_option("--cross-validate", options->folds, "Folds where there is no test set")
      ->check(number_in(2, 1000000))
      ->capture_default_str()
      ->type_name("K");
  command
      ->add_option("--peer", options->peers,
                   "Columns of Table 4 for another program: DIR/<scene>/labels.png or DIR/<scene>.png are its label "
                   "images; may be repeated")
      ->type_name("NAME=DIR")
      ->expected(1)
      ->take_all();
  command
      ->add_option("--also-test", options->further,
                   "A row of Table 4 for other labelled scenes, segmented by the model of all scenes to learn from; "
                   "may be repeated")
      ->type_name("NAME=SCENES")
      ->expected(1)
      ->take_all();
  add_pipeline_options(*command, options->pipeline, "paper.yaml");
  command->add_flag("--json", options->json, "Print every result as JSON, for programs");
  command->footer("Example: gestalt reproduce osd --output report --also-test others=labelled --peer LCCP=lccp");
  command->callback([options, &run] { run = [options] { return reproduce(*options); }; });
}

const Subcommand subcommand(60, add_reproduce);

}  // namespace

}  // namespace gestalt::app::reproduce_command
