// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/experiment/plot.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <regex>

namespace gestalt::test {
namespace {

int count(const std::string& text, const std::string& part) {
  int found = 0;
  for (std::size_t at = 0; (at = text.find(part, at)) != std::string::npos; at += part.size()) ++found;
  return found;
}

/// Every element is closed, in order; no text holds a bare special character.
void expect_well_formed(const std::string& xml) {
  std::vector<std::string> open;
  const std::regex tag("<(/?)([a-z0-9]+)([^<>]*?)(/?)>");
  for (std::sregex_iterator found(xml.begin(), xml.end(), tag); found != std::sregex_iterator(); ++found) {
    const auto& match = *found;
    if (match[1] == "/") {
      ASSERT_FALSE(open.empty());
      EXPECT_EQ(open.back(), match[2]);
      open.pop_back();
    } else if (match[4] != "/") {
      open.push_back(match[2]);
    }
  }
  EXPECT_TRUE(open.empty());
  const std::string rest = std::regex_replace(xml, tag, "");
  EXPECT_EQ(rest.find('<'), std::string::npos);
  EXPECT_FALSE(std::regex_search(rest, std::regex("&(?!amp;|lt;|gt;|quot;|#39;)")));
}

std::vector<double> bar_widths(const std::string& document) {
  std::vector<double> widths;
  const std::regex bar("<rect class=\"c[0-9]\" x=\"[-.0-9]+\" y=\"[.0-9]+\" width=\"([.0-9]+)\" height=\"10.0\"/>");
  for (std::sregex_iterator found(document.begin(), document.end(), bar); found != std::sregex_iterator(); ++found)
    widths.push_back(std::stod((*found)[1]));
  return widths;
}

TEST(BarCharts, HaveBarsAsLongAsTheirValues) {
  const std::string document = svg(BarChart{"Bars", {"a", "b", "c"}, {{"P", {50, 25, 100}}}});
  expect_well_formed(document);
  const std::vector<double> widths = bar_widths(document);
  ASSERT_EQ(widths.size(), 4u);  // the first is the legend's
  EXPECT_NEAR(widths[1], 230, 0.1);
  EXPECT_NEAR(widths[2], 115, 0.1);
  EXPECT_NEAR(widths[3], 460, 0.1);
  EXPECT_EQ(count(document, ">25.0</text>"), 1);
}

TEST(BarCharts, ReachToBothSidesOfZero) {
  const std::string document = svg(BarChart{"Deltas", {"a", "b"}, {{"P", {-1, 3}}}, 2});
  const std::vector<double> widths = bar_widths(document);
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_NEAR(widths[2] / widths[1], 3, 0.01);
  EXPECT_EQ(count(document, ">-1.00</text>"), 1);
}

TEST(BarCharts, LeaveOutWhatIsNoNumber) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const auto& values : {std::vector{nan, inf, -inf}, std::vector{nan, 0.0, 0.0}}) {
    const std::string document = svg(BarChart{"t", {"a", "b", "c"}, {{"P", values}}, 1, true});
    expect_well_formed(document);
    EXPECT_EQ(document.find("nan"), std::string::npos);
    EXPECT_EQ(document.find("inf"), std::string::npos);
  }
  expect_well_formed(svg(BarChart{}));
}

TEST(BarCharts, CompareWithTheFirst) {
  const BarChart chart{"t", {"a", "b"}, {{"P", {1, 2}}, {"R", {3, 4}}}, 1, true};
  EXPECT_EQ(count(svg(chart), "<line class=\"l"), 2);
}

TEST(Scatter, ShowsEveryPointAndThoseOfTheCornerAgain) {
  const ScatterPlot plot{"Fig", "recall", "precision", {{"boxes", {{0.5, 0.5}, {0.95, 1}, {1, 1}, {NAN, 1}}}}, 0.9};
  const std::string document = svg(plot);
  expect_well_formed(document);
  EXPECT_EQ(count(document, "<circle"), 5);
  EXPECT_EQ(count(document, "cx=\"210.0\" cy=\"210.0\""), 1);  // 0.5, 0.5: the middle of the left square
  EXPECT_EQ(count(document, "cx=\"580.0\" cy=\"60.0\""), 1);   // 0.95, 1: the middle of the right one's upper side
}

TEST(Reliability, ShowsBinsThatHaveSamples) {
  const std::string document =
      svg(ReliabilityDiagram{"Pairs", {{"structural", {{0.1, 0, 1000}, {NAN, NAN, 0}, {0.5, 0.5, 1}}}}});
  expect_well_formed(document);
  EXPECT_EQ(document.find("nan"), std::string::npos);
  EXPECT_EQ(count(document, "<circle"), 2);
  EXPECT_EQ(count(document, "cx=\"240.0\" cy=\"240.0\""), 1);  // 0.5, 0.5: on the diagonal, in the middle
  EXPECT_EQ(count(document, "<line class=\"l0\""), 1);
  EXPECT_EQ(count(document, "width=\"3.0\" height=\"42.0\""), 1);  // three decades of 1000 pairs
  EXPECT_EQ(count(document, "width=\"3.0\" height=\"1.0\""), 1);   // one pair can be seen
  expect_well_formed(svg(ReliabilityDiagram{}));
}

TEST(PlotText, IsEscaped) {
  const std::string evil = "</text><script>\"&'\x01";
  EXPECT_EQ(escape_xml(evil), "&lt;/text&gt;&lt;script&gt;&quot;&amp;&#39;\xEF\xBF\xBD");
  const std::string chart = svg(BarChart{evil, {evil}, {{evil, {1}}}});
  expect_well_formed(chart);
  EXPECT_EQ(chart.find("<script"), std::string::npos);
  const std::string plot = svg(ScatterPlot{evil, evil, evil, {{evil, {{1, 1}}}}});
  expect_well_formed(plot);
  EXPECT_EQ(plot.find("<script"), std::string::npos);
}

}  // namespace
}  // namespace gestalt::test
