// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/reproduction.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "cells.h"
#include "comparison.h"
#include "gestalt/core/base/error.h"
#include "gestalt/evaluation/experiment/plot.h"
#include "gestalt/io/scene/input.h"
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

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

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

double percent_of(const ExperimentResult* result, double CategoryScore::*member) {
  return result ? 100 * (result->all().*member) : not_a_number;
}

double balanced_error(const ExperimentResult* result, Level level) {
  if (!result) return not_a_number;
  return 100 * (level == Level::structural ? result->structural : result->assembly).balanced_error;
}

/// A table of the paper, with ours beside it.
struct ComparedTable {
  std::string name;
  std::string title;
  std::string introduction{};
  TextTable text{};
  Comparison cells{};

  /// The head of three columns: ours, the paper's, and the difference.
  void add_columns(const std::string& ours) { append(text.head, {ours, "paper", "diff."}); }

  /// Their cells at the end of a row. A percentage is compared, if both are numbers.
  void add_cells(std::vector<std::string>& row, const std::string& column, double ours, double paper, int decimals = 2,
                 bool is_percentage = true) {
    const double difference = ours - paper;
    const std::string sign = difference > 0 ? "+" : "";
    append(row, {cell(ours, decimals), cell(paper, decimals),
                 std::isnan(difference) ? no_number : sign + cell(difference, decimals)});
    if (is_percentage && std::isfinite(difference)) cells.push_back({row.front(), column, ours, paper});
  }
};

/// Table 2 or 3.
ComparedTable relation_table(const Results& results, Level level) {
  const std::span<const paper::RelationScores> of_paper =
      level == Level::structural ? paper::table_2() : paper::table_3();
  // The paper gives Table 3's F-scores in thousandths.
  const int decimals = level == Level::structural ? 3 : 5;
  ComparedTable table =
      level == Level::structural
          ? ComparedTable{"Table 2", "values of the structural level"}
          : ComparedTable{"Table 3", "values of the assembly level, besides the whole structural level"};
  table.introduction =
      "F is the F-score of Eq. 12 on the training pairs, BER the balanced error on the others. P and R with this value "
      "alone, P* and R* with all but this.";
  table.text.head = {"value"};
  for (const char* column : {"F", "BER", "P", "R", "P*", "R*"}) table.add_columns(column);
  const auto add = [&](const std::string& name, double f_score, const ExperimentResult* only,
                       const ExperimentResult* without) {
    const auto* scores = find_row(of_paper, [&](const paper::RelationScores& s) { return s.value == name; });
    const paper::RelationScores paper = scores ? *scores : paper::unknown_relation;
    std::vector<std::string> row{name};
    table.add_cells(row, "F", f_score, paper.f_score, decimals, false);
    table.add_cells(row, "BER", balanced_error(only, level), paper.balanced_error);
    table.add_cells(row, "P", percent_of(only, &CategoryScore::precision), paper.precision);
    table.add_cells(row, "R", percent_of(only, &CategoryScore::recall), paper.recall);
    table.add_cells(row, "P*", percent_of(without, &CategoryScore::precision), paper.precision_without);
    table.add_cells(row, "R*", percent_of(without, &CategoryScore::recall), paper.recall_without);
    table.text.rows.push_back(std::move(row));
  };
  const ExperimentResult* const all = results.all_of(level);
  if (all)
    for (const ValueScore& value : level == Level::structural ? all->structural_values : all->assembly_values) {
      const std::string name = std::string(name_of(level)) + "." + value.name;
      add(value.name, value.f_score, results.find("only " + name), results.find("without " + name));
    }
  add("all", not_a_number, all, nullptr);
  return table;
}

/// The row of a category; null when there is none.
const CategoryScore* find_category(const std::vector<CategoryScore>& scores, const std::string& category) {
  return find_row(std::span(scores), [&](const CategoryScore& score) { return score.category == category; });
}

const CategoryScore* find_category(const ExperimentResult* result, const std::string& category) {
  if (!result) return nullptr;
  const CategoryScore* const own = find_category(result->scores, category);
  return own ? own : find_category(result->further, category);
}

double percent_of(const CategoryScore* score, double CategoryScore::*member) {
  return score ? 100 * (score->*member) : not_a_number;
}

/// Categories, all, the paper's further dataset, and further sets of ours.
std::vector<std::string> rows_of_table_4(const ExperimentResult& any) {
  std::vector<std::string> rows;
  for (const CategoryScore& score : any.scores) rows.push_back(score.category);
  rows.emplace_back(paper::willow_garage);
  for (const CategoryScore& score : any.further)
    if (score.category != paper::willow_garage) rows.push_back(score.category);
  return rows;
}

ComparedTable table_4(const Results& results, const std::vector<PeerScores>& peers) {
  const ExperimentResult* const structural = results.all_of(Level::structural);
  const ExperimentResult* const both = results.all_of(Level::assembly);
  ComparedTable table{"Table 4", "categories, structural level (st) and both levels (st+as)"};
  table.text.head = {"category"};
  for (const char* column : {"st: P", "st: R", "st+as: P", "st+as: R"}) table.add_columns(column);
  append(table.text.head, {"Mishra: P", "R"});
  for (const PeerScores& peer : peers) append(table.text.head, {peer.name + ": P", "R"});
  const ExperimentResult* const any = structural ? structural : both;
  if (!any) return table;
  for (const std::string& category : rows_of_table_4(*any)) {
    const auto* scores =
        find_row(paper::table_4(), [&](const paper::CategoryScores& s) { return s.category == category; });
    const paper::CategoryScores paper = scores ? *scores : paper::unknown_category;
    const CategoryScore* const st = find_category(structural, category);
    const CategoryScore* const st_as = find_category(both, category);
    std::vector<std::string> row{category};
    table.add_cells(row, "st P", percent_of(st, &CategoryScore::precision), paper.structural_precision);
    table.add_cells(row, "st R", percent_of(st, &CategoryScore::recall), paper.structural_recall);
    table.add_cells(row, "st+as P", percent_of(st_as, &CategoryScore::precision), paper.assembly_precision);
    table.add_cells(row, "st+as R", percent_of(st_as, &CategoryScore::recall), paper.assembly_recall);
    append(row, {cell(paper.mishra_precision, 2), cell(paper.mishra_recall, 2)});
    for (const PeerScores& peer : peers) {
      const CategoryScore* const own = find_category(peer.scores, category);
      const CategoryScore* const score = own ? own : find_category(peer.further, category);
      append(row, {cell(percent_of(score, &CategoryScore::precision), 2),
                   cell(percent_of(score, &CategoryScore::recall), 2)});
    }
    table.text.rows.push_back(std::move(row));
  }
  return table;
}

constexpr double reported_points = 2;  // a larger difference is reported in words

/// Why figures may differ from the paper's, whatever the table.
std::string general_reasons(const Reproduction& reproduction) {
  std::string text;
  if (!reproduction.papers_config) text += " The config is not configs/paper.yaml.";
  if (reproduction.protocol.test.empty())
    text += " The paper's figures are of its test set, with jumbled scenes that the learn set lacks.";
  return text;
}

/// Why a table of configs/paper.yaml differs, as far as it is known.
std::string reasons(const ComparedTable& table) {
  const auto above = [&](const std::string& column) { return exceeds(table.cells, column, reported_points); };
  const auto below = [&](const std::string& column) { return falls_short(table.cells, column, reported_points); };
  std::string text;
  if (below("BER") || above("BER"))
    text += " BER: Eq. 13 as printed divides by the predicted counts, ours by the true ones.";
  if (table.name == "Table 2" && (below("P") || above("P")))
    text += " P: one value alone joins objects with the table, whose pixels are then false; how many do decides.";
  if (table.name == "Table 3" && (below("P") || above("P") || below("R") || above("R")))
    text += " P, R: with one value alone few pairs or none are joined, so that they are those of the structural level.";
  if (table.name == "Table 3" && (above("P*") || above("R*")))
    text +=
        " P*, R*: the authors' program computes some relations of this level with faults that ours does not have "
        "(docs/method.md); the printed R* of r_lg, 69.97, is below the 95.48 of the structural level, to which this "
        "level only adds joins.";
  if (below("st R"))
    text +=
        " st R: the inside and outside of mugs and bowls, and the two parts of an occluded object, do not touch; only "
        "the assembly level can join them.";
  if (above("st+as P"))
    text +=
        " st+as P: the authors' relations of the assembly level, which have faults (docs/method.md), join more pairs "
        "wrongly.";
  return text;
}

/// Tables 2 to 4, as far as the config has them.
std::vector<ComparedTable> compared_tables(const Reproduction& reproduction) {
  const Results results(reproduction.results);
  std::vector<ComparedTable> tables{relation_table(results, Level::structural)};
  if (results.all_of(Level::assembly)) tables.push_back(relation_table(results, Level::assembly));
  tables.push_back(table_4(results, reproduction.peers));
  return tables;
}

/// The line below a table.
Paragraph remark(const ComparedTable& table, const Reproduction& reproduction) {
  if (table.cells.empty()) return {"Nothing here has a counterpart in the paper."};
  const std::string words = differences_in_words(table.cells, reported_points);
  if (words.empty()) return {"No percentage differs from the paper's by more than two points."};
  return {"More than two points from the paper: " + words + "." + general_reasons(reproduction) +
          (reproduction.papers_config ? reasons(table) : "")};
}

/// How many percentages are how near to the paper's, for each table and all.
struct Nearness {
  std::string table;
  int percentages;
  int within_1;  // point
  int within_3;
};

std::vector<Nearness> nearness(const std::vector<ComparedTable>& tables) {
  std::vector<Nearness> rows;
  Nearness all{"all", 0, 0, 0};
  for (const ComparedTable& table : tables) {
    rows.push_back({table.name, int(table.cells.size()), count_within(table.cells, 1), count_within(table.cells, 3)});
    all.percentages += rows.back().percentages;
    all.within_1 += rows.back().within_1;
    all.within_3 += rows.back().within_3;
  }
  rows.push_back(all);
  return rows;
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
                     ": is not a folder, but there is a folder test; both sets are needed to train on "
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
  if (!config.with_assembly) return variants;
  const Variant both{both_levels, config};
  variants.push_back(both);
  add_each(both, "assembly.values", Level::assembly);
  return variants;
}

Report reproduction_report(const Reproduction& reproduction) {
  const Protocol& protocol = reproduction.protocol;
  const Results results(reproduction.results);
  const ExperimentResult* const structural = results.all_of(Level::structural);
  const ExperimentResult* const both = results.all_of(Level::assembly);
  Report report{"Tables of Richtsfeld et al. 2014", {}};
  std::string text = description(protocol) +
                     " Percent, but for counts and F. Beside our numbers are the paper's, where it has a row of the "
                     "same name, and the difference; they are of its 66 test scenes";
  text += protocol.test.empty() ? ", not of the scenes here." : ".";
  if (!both) text += " The config has no assembly level (levels: structural), so there is no Table 3.";
  report.blocks.emplace_back(Paragraph{text});

  report.blocks.emplace_back(Heading{"Table 1: images, objects, pairs of patches"});
  report.blocks.emplace_back(
      Paragraph{"r_st are neighbours in 3D, r_as all other pairs of patches that the structural level leaves in "
                "different groups; same are those of one object."});
  if (const ExperimentResult* any = both ? both : structural) report.blocks.emplace_back(table_1(*any));

  std::vector<ComparedTable> tables = compared_tables(reproduction);
  for (ComparedTable& table : tables) {
    report.blocks.emplace_back(Heading{table.name + ": " + table.title});
    if (!table.introduction.empty()) report.blocks.emplace_back(Paragraph{table.introduction});
    report.blocks.emplace_back(std::move(table.text));
    report.blocks.emplace_back(remark(table, reproduction));
  }

  report.blocks.emplace_back(Heading{"Figure 5: each object"});
  if (structural) {
    report.blocks.emplace_back(figure_5_text(*structural, "structural level"));
    report.blocks.emplace_back(figure_5(*structural, "figure_5_structural.svg", "structural level"));
  }
  if (both) {
    report.blocks.emplace_back(figure_5_text(*both, "both levels"));
    report.blocks.emplace_back(figure_5(*both, "figure_5_assembly.svg", "both levels"));
  }

  report.blocks.emplace_back(Heading{"Summary: percentages of Tables 2 to 4 beside the paper's"});
  TextTable summary{{"table", "percentages", "within 1 point", "within 3 points"}, {}};
  for (const Nearness& row : nearness(tables))
    summary.rows.push_back({row.table, number(row.percentages), number(row.within_1), number(row.within_3)});
  report.blocks.emplace_back(std::move(summary));
  return report;
}

nlohmann::ordered_json reproduction_json(const Reproduction& reproduction) {
  nlohmann::ordered_json json;
  for (const auto& [name, result] : reproduction.results)
    json["variants"][name] = result ? to_json(*result) : nlohmann::ordered_json(nullptr);
  json["peers"] = nlohmann::ordered_json::object();
  for (const PeerScores& peer : reproduction.peers)
    json["peers"][peer.name] = {{"scores", to_json(peer.scores)}, {"further", to_json(peer.further)}};
  for (const Nearness& row : nearness(compared_tables(reproduction)))
    json["summary"][row.table] = {
        {"percentages", row.percentages}, {"within_1", row.within_1}, {"within_3", row.within_3}};
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
                                  {"assembly_R", row.assembly_recall},
                                  {"mishra_P", row.mishra_precision},
                                  {"mishra_R", row.mishra_recall}};
  });
  return json;
}

}  // namespace gestalt
