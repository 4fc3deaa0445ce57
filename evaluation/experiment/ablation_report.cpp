// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <cmath>
#include <limits>

#include "cells.h"
#include "gestalt/evaluation/experiment/ablation.h"
#include "gestalt/evaluation/experiment/plot.h"
#include "number_text.h"

namespace gestalt {

namespace {

/// A number of a result by which variants are compared.
struct Measurement {
  const char* name;
  double (*of)(const ExperimentResult&);
};

constexpr Measurement precision{"P", [](const ExperimentResult& r) { return r.all().precision; }};
constexpr Measurement recall{"R", [](const ExperimentResult& r) { return r.all().recall; }};
constexpr Measurement overlap{"overlap F", [](const ExperimentResult& r) { return r.all().overlap_f; }};
constexpr Measurement boundary{"boundary F", [](const ExperimentResult& r) { return r.all().boundary_f; }};
constexpr Measurement detected{"F > 0.75", [](const ExperimentResult& r) { return r.all().detected; }};
constexpr Measurement structural_error{"structural BER",
                                       [](const ExperimentResult& r) { return r.structural.balanced_error; }};
constexpr Measurement assembly_error{"assembly BER",
                                     [](const ExperimentResult& r) { return r.assembly.balanced_error; }};

constexpr double none = std::numeric_limits<double>::quiet_NaN();

using Show = double (*)(const ExperimentResult& result, const ExperimentResult* base, const Measurement& measurement);

double percent(const ExperimentResult& result, const ExperimentResult*, const Measurement& measurement) {
  return 100 * measurement.of(result);
}

double points_to_base(const ExperimentResult& result, const ExperimentResult* base, const Measurement& measurement) {
  return base ? 100 * (measurement.of(result) - measurement.of(*base)) : none;
}

TextTable table(const std::vector<NamedResult>& results, const std::vector<Measurement>& measurements, Show show) {
  TextTable table{{"variant"}, {}};
  for (const Measurement& measurement : measurements) table.head.emplace_back(measurement.name);
  for (const auto& [name, result] : results) {
    std::vector<std::string> row{name};
    for (const Measurement& measurement : measurements)
      row.push_back(result ? cell(show(*result, results.front().result, measurement), 2) : no_number);
    table.rows.push_back(std::move(row));
  }
  return table;
}

Plot bars(const std::string& file, const std::string& title, const std::vector<NamedResult>& results,
          const std::vector<Measurement>& measurements, Show show) {
  BarChart chart{title, {}, {}, 2};
  for (const Measurement& measurement : measurements) chart.series.push_back({measurement.name, {}});
  const bool deltas = show == points_to_base;
  chart.compare_with_first = !deltas;
  for (std::size_t i = deltas ? 1 : 0; i < results.size(); ++i) {  // the first differs from itself by nothing
    chart.labels.push_back(results[i].name);
    for (std::size_t m = 0; m < measurements.size(); ++m)
      chart.series[m].values.push_back(
          results[i].result ? show(*results[i].result, results.front().result, measurements[m]) : none);
  }
  return {file, svg(chart), title};
}

}  // namespace

Report ablation_report(const std::string& title, const std::string& protocol, const std::vector<NamedResult>& results) {
  bool with_assembly = false;
  for (const NamedResult& named : results)
    with_assembly |= named.result && named.result->assembly.positive + named.result->assembly.negative > 0;
  std::vector<Measurement> all{precision, recall, overlap, boundary, detected, structural_error};
  std::vector<Measurement> errors{structural_error};
  if (with_assembly) {
    all.push_back(assembly_error);
    errors.push_back(assembly_error);
  }
  Report report{title, {}};
  report.blocks = {
      Paragraph{protocol + " All values in percent, over all scenes. P and R are pooled over objects; overlap and "
                           "boundary F leave the table out; BER is the balanced error of a level's classifier on "
                           "pairs that it was not trained on."},
      table(results, all, percent),
      Heading{"Change against " + results.front().name + ", percentage points"},
      table(results, all, points_to_base),
      Heading{"Plots"},
      bars("ablation_pr.svg", "Precision and recall, %", results, {precision, recall}, percent),
      bars("ablation_f.svg", "Overlap F and boundary F, %", results, {overlap, boundary}, percent),
      bars("ablation_error.svg", "Balanced error of the classifiers, %", results, errors, percent)};
  if (results.size() > 1)
    report.blocks.emplace_back(bars("ablation_change.svg", "Change against " + results.front().name + ", points",
                                    results, {precision, recall, overlap}, points_to_base));
  return report;
}

TextTable ablation_rows(const std::vector<NamedResult>& results) {
  TextTable table{{"variant", "category", "images", "objects", "P", "R", "overlap_F", "boundary_F", "detected",
                   "structural_balanced_error", "assembly_balanced_error"},
                  {}};
  const auto number = [](double value) { return std::isfinite(value) ? number_text(value, 6) : ""; };
  for (const auto& [name, result] : results) {
    if (!result) continue;
    for (const CategoryScore& score : result->scores) {
      const bool all = score.category == "all";
      table.rows.push_back(
          {name, score.category, std::to_string(score.images), std::to_string(score.objects), number(score.precision),
           number(score.recall), number(score.overlap_f), number(score.boundary_f), number(score.detected),
           all ? number(result->structural.balanced_error) : "", all ? number(result->assembly.balanced_error) : ""});
    }
  }
  return table;
}

std::string description(const Protocol& protocol) {
  const std::string learn = std::to_string(protocol.learn.size());
  std::string text;
  if (!protocol.test.empty())
    text = "Trained on " + learn + " scenes, evaluated on " + std::to_string(protocol.test.size()) + " others";
  else
    text = std::to_string(protocol.folds) + "-fold cross-validation over " + learn + " scenes" +
           (protocol.seed ? ", dealt with seed " + std::to_string(protocol.seed) : "");
  for (const FurtherSet& set : protocol.further)
    text += "; " + set.name + ": " + std::to_string(set.scenes.size()) + " scenes, by the model of all " + learn;
  return text + ".";
}

}  // namespace gestalt
