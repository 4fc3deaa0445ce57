// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/reproduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cells.h"
#include "gestalt/error.h"
#include "gestalt/input.h"
#include "gestalt/plot.h"
#include "paper_numbers.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

const std::string structural_level = "structural", both_levels = "structural+assembly";

/// Results by the names that reproduction_variants() gives.
class Results {
 public:
  explicit Results(const std::vector<NamedResult>& results) : results_(results) {}

  /// Null when there is none.
  const ExperimentResult* find(const std::string& name) const {
    const auto found =
        std::find_if(results_.begin(), results_.end(), [&](const NamedResult& named) { return named.name == name; });
    return found == results_.end() ? nullptr : found->result;
  }

  /// A level with all its values: the structural one alone, or both.
  const ExperimentResult* all_of(Level level) const {
    return find(level == Level::structural ? structural_level : both_levels);
  }

 private:
  const std::vector<NamedResult>& results_;
};

std::string percent(double share) { return cell(100 * share, 2); }

std::string number(std::int64_t count) { return std::to_string(count); }

void append(std::vector<std::string>& row, const std::vector<std::string>& cells) {
  row.insert(row.end(), cells.begin(), cells.end());
}

/// The row of a list that a predicate holds for; null when there is none.
template <class Row, class Predicate>
const Row* find_row(std::span<const Row> rows, const Predicate& holds) {
  const auto found = std::find_if(rows.begin(), rows.end(), holds);
  return found == rows.end() ? nullptr : &*found;
}

TextTable table_1(const ExperimentResult& result) {
  TextTable table{
      {"set and category", "Nr.", "Obj.", "r_st", "same", "r_as", "same", "paper: Nr.", "Obj.", "r_st", "r_as"}, {}};
  const auto add = [&](const std::string& set, const std::vector<CategoryCount>& counts) {
    for (const CategoryCount& count : counts) {
      std::vector<std::string> row{set + " " + count.category,    number(count.images),
                                   number(count.objects),         number(count.structural_pairs),
                                   number(count.structural_same), number(count.assembly_pairs),
                                   number(count.assembly_same)};
      const auto* paper = find_row(paper::table_1(), [&](const paper::Counts& of_paper) {
        return of_paper.set == set && of_paper.category == count.category;
      });
      append(row, paper ? std::vector{number(paper->images), number(paper->objects), number(paper->structural),
                                      number(paper->assembly)}
                        : std::vector(4, no_number));
      table.rows.push_back(std::move(row));
    }
  };
  add("learn", result.learn);
  add("test", result.test);
  return table;
}

std::vector<std::string> precision_and_recall(const ExperimentResult* result) {
  if (!result) return {no_number, no_number};
  return {percent(result->all().precision), percent(result->all().recall)};
}

std::string balanced_error(const ExperimentResult* result, Level level) {
  if (!result) return no_number;
  return percent((level == Level::structural ? result->structural : result->assembly).balanced_error);
}

/// Table 2 or 3.
TextTable relation_table(const Results& results, Level level) {
  const std::span<const paper::RelationScores> of_paper =
      level == Level::structural ? paper::table_2() : paper::table_3();
  // The paper gives Table 3's F-scores in thousandths.
  const int decimals = level == Level::structural ? 3 : 5;
  TextTable table{{"value", "F", "BER", "P", "R", "P*", "R*", "paper: F", "BER", "P", "R", "P*", "R*"}, {}};
  const auto add_paper = [&](const std::string& name, std::vector<std::string>& row) {
    const auto* scores = find_row(of_paper, [&](const paper::RelationScores& s) { return s.value == name; });
    append(row, scores ? std::vector{cell(scores->f_score, decimals), cell(scores->balanced_error, 1),
                                     cell(scores->precision, 2), cell(scores->recall, 2),
                                     cell(scores->precision_without, 2), cell(scores->recall_without, 2)}
                       : std::vector(6, no_number));
  };
  const ExperimentResult* const all = results.all_of(level);
  if (all)
    for (const ValueScore& value : level == Level::structural ? all->structural_values : all->assembly_values) {
      const std::string name = std::string(name_of(level)) + "." + value.name;
      const ExperimentResult* const only = results.find("only " + name);
      std::vector<std::string> row{value.name, cell(value.f_score, decimals), balanced_error(only, level)};
      append(row, precision_and_recall(only));
      append(row, precision_and_recall(results.find("without " + name)));
      add_paper(value.name, row);
      table.rows.push_back(std::move(row));
    }
  std::vector<std::string> row{"all", no_number, balanced_error(all, level)};
  append(row, precision_and_recall(all));
  append(row, {no_number, no_number});
  add_paper("all", row);
  table.rows.push_back(std::move(row));
  return table;
}

std::vector<std::string> category_cells(const ExperimentResult* result, const std::string& category) {
  if (result)
    for (const CategoryScore& score : result->scores)
      if (score.category == category) return {percent(score.precision), percent(score.recall)};
  return {no_number, no_number};
}

TextTable table_4(const Results& results) {
  const ExperimentResult* const structural = results.all_of(Level::structural);
  const ExperimentResult* const both = results.all_of(Level::assembly);
  TextTable table{{"category", "st: P", "R", "st+as: P", "R", "paper: st: P", "R", "st+as: P", "R"}, {}};
  const ExperimentResult* const any = structural ? structural : both;
  if (!any) return table;
  for (const CategoryScore& score : any->scores) {
    std::vector<std::string> row{score.category};
    append(row, category_cells(structural, score.category));
    append(row, category_cells(both, score.category));
    const auto* of_paper = find_row(
        paper::table_4(), [&](const paper::CategoryScores& scores) { return scores.category == score.category; });
    append(row, of_paper ? std::vector{cell(of_paper->structural_precision, 2), cell(of_paper->structural_recall, 2),
                                       cell(of_paper->assembly_precision, 2), cell(of_paper->assembly_recall, 2)}
                         : std::vector(4, no_number));
    table.rows.push_back(std::move(row));
  }
  return table;
}

Plot figure_5(const ExperimentResult& result, const std::string& file, const std::string& levels) {
  ScatterPlot plot{"Precision over recall of each object, " + levels, "recall", "precision", {}, 0.9};
  for (const ObjectScore& object : result.objects) {
    const std::string name = object.category.empty() ? "no category" : object.category;
    auto series = std::find_if(plot.series.begin(), plot.series.end(), [&](const auto& s) { return s.name == name; });
    if (series == plot.series.end()) series = plot.series.insert(plot.series.end(), {name, {}});
    series->points.push_back({object.recall, object.precision});
  }
  return {file, svg(plot), plot.title};
}

/// How many objects lie where in Figure 5.
Paragraph figure_5_text(const ExperimentResult& result, const std::string& levels) {
  std::size_t good = 0, over = 0, under = 0, both = 0;
  for (const ObjectScore& object : result.objects) {
    const bool precise = object.precision >= 0.9, recalled = object.recall >= 0.9;
    ++(precise && recalled ? good : precise ? over : recalled ? under : both);
  }
  return {"Of " + std::to_string(result.objects.size()) + " objects (" + levels + ") " + std::to_string(good) +
          " have both at 0.9 or above; " + std::to_string(over) + " only precision (in parts), " +
          std::to_string(under) + " only recall (merged with others), " + std::to_string(both) + " neither."};
}

template <class Row>
nlohmann::ordered_json json_rows(std::span<const Row> rows, const auto& to_json_of_row) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const Row& row : rows) json.push_back(to_json_of_row(row));
  return json;
}

nlohmann::ordered_json finite(double value) {
  return std::isfinite(value) ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

nlohmann::ordered_json relation_json(const paper::RelationScores& row) {
  return {{"value", row.value},
          {"F", finite(row.f_score)},
          {"BER", row.balanced_error},
          {"P", row.precision},
          {"R", row.recall},
          {"P*", finite(row.precision_without)},
          {"R*", finite(row.recall_without)}};
}

}  // namespace

Protocol find_protocol(const fs::path& data, int folds) {
  Protocol protocol;
  protocol.folds = folds;
  const fs::path learn = data / "learn", test = data / "test";
  std::error_code error;
  const bool has_learn = fs::is_directory(learn, error), has_test = fs::is_directory(test, error);
  if (has_test && !has_learn)
    throw InputError(learn.string() +
                     ": is no folder, but there is a folder test; both sets are needed to train on "
                     "one and evaluate on the other");
  protocol.learn = find_scenes({has_learn ? learn : data});
  if (has_test) protocol.test = find_scenes({test});
  return protocol;
}

std::vector<Variant> reproduction_variants(const Config& config, const Registry& registry) {
  Variant structural{structural_level, config};
  structural.config.with_assembly = false;
  std::vector<Variant> variants{structural};
  const auto add_each = [&](const Variant& base, const std::string& values, Level level) {
    for (const EachMode mode : {EachMode::only, EachMode::without}) {
      if (mode == EachMode::without && level_values(base.config, registry, level).size() < 2) continue;
      const std::vector<Variant> more = each(base, registry, values, mode);
      variants.insert(variants.end(), more.begin(), more.end());
    }
  };
  add_each(structural, "structural.values", Level::structural);
  if (!config.assembly) return variants;
  Variant both{both_levels, config};
  both.config.with_assembly = true;
  variants.push_back(both);
  add_each(both, "assembly.values", Level::assembly);
  return variants;
}

Report reproduction_report(const Protocol& protocol, const std::vector<NamedResult>& named) {
  const Results results(named);
  const ExperimentResult* const structural = results.all_of(Level::structural);
  const ExperimentResult* const both = results.all_of(Level::assembly);
  Report report{"Tables of Richtsfeld et al. 2014", {}};
  std::string text = description(protocol) +
                     " Percent, but for counts and F. Beside our numbers are the paper's, where it has a row of the "
                     "same name; they are of its 66 test scenes";
  text += protocol.test.empty() ? ", not of the scenes here." : ".";
  if (!both) text += " The config has no assembly level, so there is no Table 3.";
  report.blocks.emplace_back(Paragraph{text});

  report.blocks.emplace_back(Heading{"Table 1: images, objects, pairs of patches"});
  report.blocks.emplace_back(
      Paragraph{"r_st are neighbours in 3D, r_as all other pairs of patches that the structural level leaves in "
                "different groups; "
                "same are those of one object."});
  if (const ExperimentResult* any = both ? both : structural) report.blocks.emplace_back(table_1(*any));

  const std::string columns =
      "F is the F-score of Eq. 12 on the training pairs, BER the balanced error on the others. P and R with this value "
      "alone, P* and R* with all but this.";
  report.blocks.emplace_back(Heading{"Table 2: values of the structural level"});
  report.blocks.emplace_back(Paragraph{columns});
  report.blocks.emplace_back(relation_table(results, Level::structural));
  if (both) {
    report.blocks.emplace_back(Heading{"Table 3: values of the assembly level, besides the whole structural level"});
    report.blocks.emplace_back(Paragraph{columns});
    report.blocks.emplace_back(relation_table(results, Level::assembly));
  }
  report.blocks.emplace_back(Heading{"Table 4: categories, structural level (st) and both levels (st+as)"});
  report.blocks.emplace_back(table_4(results));

  report.blocks.emplace_back(Heading{"Figure 5: each object"});
  if (structural) {
    report.blocks.emplace_back(figure_5_text(*structural, "structural level"));
    report.blocks.emplace_back(figure_5(*structural, "figure_5_structural.svg", "structural level"));
  }
  if (both) {
    report.blocks.emplace_back(figure_5_text(*both, "both levels"));
    report.blocks.emplace_back(figure_5(*both, "figure_5_assembly.svg", "both levels"));
  }
  return report;
}

nlohmann::ordered_json reproduction_json(const std::vector<NamedResult>& results) {
  nlohmann::ordered_json json;
  for (const auto& [name, result] : results)
    json["variants"][name] = result ? to_json(*result) : nlohmann::ordered_json(nullptr);
  json["paper"]["table_1"] = json_rows(paper::table_1(), [](const paper::Counts& row) {
    return nlohmann::ordered_json{{"set", row.set},         {"category", row.category},     {"images", row.images},
                                  {"objects", row.objects}, {"structural", row.structural}, {"assembly", row.assembly}};
  });
  json["paper"]["table_2"] = json_rows(paper::table_2(), relation_json);
  json["paper"]["table_3"] = json_rows(paper::table_3(), relation_json);
  json["paper"]["table_4"] = json_rows(paper::table_4(), [](const paper::CategoryScores& row) {
    return nlohmann::ordered_json{{"category", row.category},
                                  {"structural_P", row.structural_precision},
                                  {"structural_R", row.structural_recall},
                                  {"assembly_P", row.assembly_precision},
                                  {"assembly_R", row.assembly_recall}};
  });
  return json;
}

}  // namespace gestalt
