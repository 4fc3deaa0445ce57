// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "experiments.h"

#include <algorithm>
#include <iostream>
#include <set>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "progress_bar.h"

namespace gestalt::app {

namespace fs = std::filesystem;

std::vector<ExperimentOutcome> run_with_progress(const std::vector<Variant>& variants, const Registry& registry,
                                                 const Protocol& protocol, const OutputPath& store) {
  for (const OutputPath& folder : {store, OutputPath(store.named())}) remove_abandoned(folder);
  const ProgressBar bar(variants.size());
  const ExperimentEvents events{
      [&](std::size_t done, std::size_t, const std::string& variant) { bar.show(done, variant); },
      [&](const std::string& message) {
        bar.clear();
        std::cerr << "gestalt: warning: " << message << '\n';
      }};
  bar.show(0, "features of the scenes");
  std::vector<ExperimentOutcome> outcomes = run_experiments(variants, registry, protocol, store, events);
  bar.clear();
  if (std::none_of(outcomes.begin(), outcomes.end(), [](const auto& outcome) { return outcome.result.has_value(); }))
    std::rethrow_exception(outcomes.front().failure);
  for (std::size_t i = 0; i < outcomes.size(); ++i) try {
      if (outcomes[i].failure) std::rethrow_exception(outcomes[i].failure);
    } catch (const std::exception& error) {
      std::cerr << "gestalt: error: " << variants[i].name << ": " << error.what() << '\n';
    }
  return outcomes;
}

std::vector<NamedResult> named(const std::vector<Variant>& variants, const std::vector<ExperimentOutcome>& outcomes) {
  std::vector<NamedResult> results;
  for (std::size_t i = 0; i < variants.size(); ++i)
    results.push_back({variants[i].name, outcomes[i].result ? &*outcomes[i].result : nullptr});
  return results;
}

int exit_code(const std::vector<ExperimentOutcome>& outcomes) {
  const bool failed = std::any_of(outcomes.begin(), outcomes.end(), [](const auto& o) { return !o.result; });
  return failed ? run_failed : success;
}

std::vector<OutputFile> report_files(const Report& report, const OutputPath& folder, const std::string& name) {
  std::vector<OutputFile> files{{folder / (name + ".md"), markdown(report)}, {folder / (name + ".html"), html(report)}};
  for (const ReportBlock& block : report.blocks)
    if (const auto* plot = std::get_if<Plot>(&block)) files.push_back({folder / plot->file, plot->svg});
  return files;
}

void require_apart(const Protocol& protocol) {
  std::set<fs::path> learnt;
  for (const fs::path& scene : protocol.learn) learnt.insert(fs::weakly_canonical(scene));
  const auto require_new = [&](const std::vector<fs::path>& scenes) {
    for (const fs::path& scene : scenes)
      if (learnt.contains(fs::weakly_canonical(scene)))
        throw ConfigError(
            scene.string() +
            ": is both a training scene and a test scene; test a model on scenes that it was not trained on");
  };
  require_new(protocol.test);
  for (const FurtherSet& set : protocol.further) require_new(set.scenes);
}

}  // namespace gestalt::app
