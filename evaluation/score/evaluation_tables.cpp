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

/// Adds what rows and images hold of the values that a row has means of.
template <class Scored>
void add_means(const Scored& from, ScoreRow& sum) {
  sum.segments += double(from.segments);
  for (std::size_t rule = 0; rule < sum.overlap_boundary.size(); ++rule)
    add(from.overlap_boundary[rule], overlap_boundary_values, sum.overlap_boundary[rule]);
  add(from.all_parts, part_values, sum.all_parts);
  add(from.object_parts, part_values, sum.object_parts);
}

void divide_means(ScoreRow& sum, double count) {
  sum.segments /= count;
  for (OverlapBoundary& values : sum.overlap_boundary) divide(values, overlap_boundary_values, count);
  divide(sum.all_parts, part_values, count);
  divide(sum.object_parts, part_values, count);
}

ScoreRow summarise_images(const std::string& category, const std::vector<const ImageScore*>& scores) {
  ScoreRow row;
  row.category = category;
  row.images = std::int64_t(scores.size());
  PooledPixels pooled;
  for (const ImageScore* score : scores) {
    row.regions += score->regions;
    pooled += score->pooled;
    add_means(*score, row);
  }
  row.precision = pooled.precision();
  row.recall = pooled.recall();
  divide_means(row, double(scores.size()));
  return row;
}

ScoreRow mean_of(const std::vector<ScoreRow>& categories) {
  ScoreRow mean;
  mean.category = "mean";
  for (const ScoreRow& row : categories) {
    mean.images += row.images;
    mean.regions += row.regions;
    mean.precision += row.precision;
    mean.recall += row.recall;
    add_means(row, mean);
  }
  const auto count = double(categories.size());
  mean.precision /= count;
  mean.recall /= count;
  divide_means(mean, count);
  return mean;
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

std::string name_of(RegionKind kind) { return kind == RegionKind::parts ? "parts" : "objects"; }

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
  std::size_t category_width = 18;
  for (const ScoreRow& row : rows) category_width = std::max(category_width, row.category.size());
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

std::vector<ScoreRow> with_mean(std::vector<ScoreRow> rows) {
  if (rows.size() > 2) rows.insert(rows.end() - 1, mean_of({rows.begin(), rows.end() - 1}));
  return rows;
}

std::string_view meaning(BackgroundRule rule) {
  constexpr std::array<std::string_view, background_rule_names.size()> meanings{
      "the largest segment is background if more than half of it lies on background",
      "the largest segment is background, whatever it lies on",
      "every segment with more than half of it on background is background (optimistic)",
      "no segment is taken for background"};
  return meanings[std::size_t(rule)];
}

std::string format_tables(const std::vector<ScoreRow>& rows, RegionKind kind, BackgroundRule rule) {
  const auto of_rule = [&](double OverlapBoundary::*value) {
    return [=](const ScoreRow& row) { return 100 * (row.overlap_boundary[std::size_t(rule)].*value); };
  };
  return table("share of " + name_of(kind) +
                   " with F > 0.75, overlap F, boundary F [%]: means over the images of a row;" +
                   " mean: over the categories",
               {{"images", 0, [](const ScoreRow& row) { return double(row.images); }},
                {"F>.75", 2, of_rule(&OverlapBoundary::detected)},
                {"oF", 2, of_rule(&OverlapBoundary::overlap_f)},
                {"bF", 2, of_rule(&OverlapBoundary::boundary_f)}},
               rows) +
         table("P and R pooled over " + name_of(kind) + " [%]: one joined with the table costs many points of P",
               {{"images", 0, [](const ScoreRow& row) { return double(row.images); }},
                {"regions", 0, [](const ScoreRow& row) { return double(row.regions); }},
                {"segs/img", 1, [](const ScoreRow& row) { return row.segments; }},
                {"P", 2, [](const ScoreRow& row) { return 100 * row.precision; }},
                {"R", 2, [](const ScoreRow& row) { return 100 * row.recall; }}},
               rows);
}

std::string format_other_tables(const std::vector<ScoreRow>& rows, RegionKind kind) {
  std::string text;
  for (std::size_t rule = 0; rule < background_rule_names.size(); ++rule) {
    std::vector<Column> columns;
    for (const auto& [name, value] : overlap_boundary_values)
      columns.push_back(
          {name, 2, [=, member = value](const ScoreRow& row) { return 100 * (row.overlap_boundary[rule].*member); }});
    text += table("overlap and boundary of " + name_of(kind) + ", rule " + std::string(background_rule_names[rule]) +
                      ", mean over images [%]: " + std::string(meaning(BackgroundRule(rule))),
                  columns, rows);
  }
  std::vector<Column> columns;
  for (const auto part_score : {&ScoreRow::all_parts, &ScoreRow::object_parts})
    for (const auto& [name, value] : part_values)
      columns.push_back(
          {name, 2, [=, member = value](const ScoreRow& row) { return 100 * ((row.*part_score).*member); }});
  return text +
         table("parts, mean over images [%]: left with those of the background, right of objects only", columns, rows);
}

nlohmann::ordered_json to_json(const std::vector<ScoreRow>& rows) {
  auto json = nlohmann::ordered_json::object();
  for (const ScoreRow& row : rows) {
    auto& values = json[row.category];
    values = {{"images", row.images},
              {"regions", row.regions},
              {"segments", row.segments},
              {"P", row.precision},
              {"R", row.recall}};
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
  return "\n" + level + " level: classifier on the pairs of held-out scenes\npositive" +
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
