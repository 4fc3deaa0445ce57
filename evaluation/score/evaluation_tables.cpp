// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>

#include "gestalt/evaluation/score/evaluation.h"

namespace gestalt {

namespace {

/// A value of a row, under the name by which tables and JSON show it.
template <class Values>
struct Named {
  const char* name;
  double Values::*value;
};

constexpr std::array<Named<OverlapBoundary>, 7> overlap_boundary_values{{{"oP", &OverlapBoundary::overlap_precision},
                                                                         {"oR", &OverlapBoundary::overlap_recall},
                                                                         {"oF", &OverlapBoundary::overlap_f},
                                                                         {"bP", &OverlapBoundary::boundary_precision},
                                                                         {"bR", &OverlapBoundary::boundary_recall},
                                                                         {"bF", &OverlapBoundary::boundary_f},
                                                                         {"F>.75", &OverlapBoundary::detected}}};

constexpr std::array<Named<PartScore>, 3> part_values{{{"WOv", &PartScore::weighted_overlap},
                                                       {"F_os", &PartScore::over_segmentation},
                                                       {"F_us", &PartScore::under_segmentation}}};

template <class Values, std::size_t n>
void add(const Values& from, const std::array<Named<Values>, n>& names, Values& sum) {
  for (const auto& [name, value] : names) sum.*value += from.*value;
}

template <class Values, std::size_t n>
void divide(Values& sum, const std::array<Named<Values>, n>& names, double count) {
  for (const auto& [name, value] : names) sum.*value /= count;
}

ScoreRow summarise_images(const std::string& category, const std::vector<const ImageScore*>& scores) {
  ScoreRow row;
  row.category = category;
  row.images = std::int64_t(scores.size());
  for (const ImageScore* score : scores) {
    row.regions += score->regions;
    row.segments += double(score->segments);
    row.pooled += score->pooled;
    for (std::size_t rule = 0; rule < row.overlap_boundary.size(); ++rule)
      add(score->overlap_boundary[rule], overlap_boundary_values, row.overlap_boundary[rule]);
    add(score->all_parts, part_values, row.all_parts);
    add(score->object_parts, part_values, row.object_parts);
  }
  const auto count = double(scores.size());
  row.segments /= count;
  for (OverlapBoundary& values : row.overlap_boundary) divide(values, overlap_boundary_values, count);
  divide(row.all_parts, part_values, count);
  divide(row.object_parts, part_values, count);
  return row;
}

/// With a number of decimals, whatever the locale.
std::string decimal(double value, int digits) {
  if (std::isnan(value)) return "nan";
  std::array<char, 64> text{};
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, digits).ptr;
  return {text.data(), end};
}

std::string right_aligned(const std::string& text) {
  constexpr std::size_t width = 9;
  return std::string(std::max(width, text.size()) - text.size(), ' ') + text;
}

std::string padded(std::string text, std::size_t width) {
  text.resize(std::max(width, text.size()), ' ');
  return text;
}

struct Column {
  std::string head;
  int digits;
  std::function<double(const ScoreRow&)> value;
};

std::string table(const std::string& title, const std::vector<Column>& columns, const std::vector<ScoreRow>& rows) {
  constexpr std::size_t category_width = 18;
  std::string text = "\n" + title + "\n" + padded("category", category_width);
  for (const Column& column : columns) text += right_aligned(column.head);
  for (const ScoreRow& row : rows) {
    text += "\n" + padded(row.category, category_width);
    for (const Column& column : columns) text += right_aligned(decimal(column.value(row), column.digits));
  }
  return text + "\n";
}

}  // namespace

std::vector<ScoreRow> summarise(const std::vector<ImageScore>& scores, const std::vector<std::string>& categories) {
  std::vector<std::string> order;
  for (const std::string& category : categories)
    if (!category.empty() && std::find(order.begin(), order.end(), category) == order.end()) order.push_back(category);
  std::vector<ScoreRow> rows;
  std::vector<const ImageScore*> chosen;
  for (const std::string& category : order) {
    chosen.clear();
    for (std::size_t i = 0; i < scores.size(); ++i)
      if (categories[i] == category) chosen.push_back(&scores[i]);
    rows.push_back(summarise_images(category, chosen));
  }
  chosen.clear();
  for (const ImageScore& score : scores) chosen.push_back(&score);
  rows.push_back(summarise_images("all", chosen));
  return rows;
}

std::string format_tables(const std::vector<ScoreRow>& rows, RegionKind kind) {
  constexpr std::array<const char*, background_rule_names.size()> meaning{
      "the largest segment is background if more than half of it lies on background",
      "the largest segment is background, whatever it lies on",
      "every segment with more than half of it on background is background (optimistic)",
      "no segment is taken for background"};
  const std::string regions = kind == RegionKind::parts ? "parts" : "objects";

  std::string text = table("(a) P and R pooled over " + regions + " [%]",
                           {{"images", 0, [](const ScoreRow& row) { return double(row.images); }},
                            {"regions", 0, [](const ScoreRow& row) { return double(row.regions); }},
                            {"segs/img", 1, [](const ScoreRow& row) { return row.segments; }},
                            {"P", 2, [](const ScoreRow& row) { return 100 * row.pooled.precision(); }},
                            {"R", 2, [](const ScoreRow& row) { return 100 * row.pooled.recall(); }}},
                           rows);
  for (std::size_t rule = 0; rule < meaning.size(); ++rule) {
    std::vector<Column> columns;
    for (const auto& [name, value] : overlap_boundary_values)
      columns.push_back(
          {name, 2, [=, member = value](const ScoreRow& row) { return 100 * (row.overlap_boundary[rule].*member); }});
    text += table("(b) overlap and boundary of " + regions + ", rule " + std::string(background_rule_names[rule]) +
                      ", mean over images [%]: " + meaning[rule],
                  columns, rows);
  }
  std::vector<Column> columns;
  for (const auto part_score : {&ScoreRow::all_parts, &ScoreRow::object_parts})
    for (const auto& [name, value] : part_values)
      columns.push_back(
          {name, 2, [=, member = value](const ScoreRow& row) { return 100 * ((row.*part_score).*member); }});
  return text + table("(c) parts, mean over images [%]: left with those of the background, right of objects only",
                      columns, rows);
}

nlohmann::ordered_json to_json(const std::vector<ScoreRow>& rows) {
  auto json = nlohmann::ordered_json::object();
  for (const ScoreRow& row : rows) {
    auto& values = json[row.category];
    values = {{"images", row.images},
              {"regions", row.regions},
              {"segments", row.segments},
              {"P", row.pooled.precision()},
              {"R", row.pooled.recall()}};
    for (std::size_t rule = 0; rule < row.overlap_boundary.size(); ++rule)
      for (const auto& [name, value] : overlap_boundary_values)
        values[std::string(background_rule_names[rule]) + ":" + name] = row.overlap_boundary[rule].*value;
    for (const auto& [name, value] : part_values) values[std::string("parts_all:") + name] = row.all_parts.*value;
    for (const auto& [name, value] : part_values)
      values[std::string("parts_objects:") + name] = row.object_parts.*value;
  }
  return json;
}

std::string format_pairs(const PairDecisions& pairs, const std::string& level) {
  return "\n(d) " + level + " level: classifier on the pairs of held-out scenes\npositive" +
         right_aligned(std::to_string(pairs.true_positive + pairs.false_negative)) + ", of them missed" +
         right_aligned(std::to_string(pairs.false_negative)) + "\nnegative" +
         right_aligned(std::to_string(pairs.true_negative + pairs.false_positive)) + ", of them joined" +
         right_aligned(std::to_string(pairs.false_positive)) + "\nbalanced error [%]" +
         right_aligned(decimal(100 * pairs.balanced_error(), 2)) + ", calibration error [%]" +
         right_aligned(decimal(100 * pairs.calibration_error(), 2)) + ", Brier score" +
         right_aligned(decimal(pairs.brier_score(), 4)) + "\n";
}

nlohmann::ordered_json to_json(const PairDecisions& pairs) {
  auto bins = nlohmann::ordered_json::array();
  for (const PairDecisions::Bin& bin : pairs.bins)
    bins.push_back({{"pairs", bin.pairs}, {"positive", bin.positive}, {"sum_of_probability", bin.probability}});
  return {{"true_positive", pairs.true_positive},     {"false_positive", pairs.false_positive},
          {"true_negative", pairs.true_negative},     {"false_negative", pairs.false_negative},
          {"balanced_error", pairs.balanced_error()}, {"calibration_error", pairs.calibration_error()},
          {"brier_score", pairs.brier_score()},       {"reliability", std::move(bins)}};
}

}  // namespace gestalt
