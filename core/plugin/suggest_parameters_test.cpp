// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <clocale>
#include <cmath>
#include <limits>
#include <locale>
#include <string>
#include <vector>

#include "gestalt/core/base/suggest.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {
namespace {

using Words = std::vector<std::string>;

TEST(Closest, GivesTheNearestFirst) {
  EXPECT_EQ(closest("gabr", {"fourier", "gabor", "gab"}), (Words{"gab", "gabor"}));
  EXPECT_EQ(closest("gabro", {"fourier", "gabor", "gabry"}), (Words{"gabry", "gabor"}));
}

TEST(Closest, CountsAnInsertionADeletionAndAChangeAsOneEdit) {
  // Words of six letters allow two edits.
  EXPECT_EQ(closest("plane", {"planes"}), (Words{"planes"}));
  EXPECT_EQ(closest("planes", {"plane"}), (Words{"plane"}));
  EXPECT_EQ(closest("planes", {"planet"}), (Words{"planet"}));
  EXPECT_EQ(closest("planes", {"plants"}), (Words{"plants"}));
  EXPECT_EQ(closest("planes", {"plight"}), Words{});
}

TEST(Closest, AllowsAThirdOfTheLongerWord) {
  EXPECT_EQ(closest("abcdefghi", {"abcdefxyz"}), (Words{"abcdefxyz"}));  // 3 of 9
  EXPECT_EQ(closest("abcdefghi", {"abcdewxyz"}), Words{});               // 4 of 9
}

TEST(Closest, GivesAtMostThreeAndTiesByName) {
  EXPECT_EQ(closest("bin", {"bind", "bing", "bins", "bina"}), (Words{"bina", "bind", "bing"}));
}

TEST(Closest, OfNoCandidatesIsEmpty) { EXPECT_TRUE(closest("x", {}).empty()); }

TEST(DidYouMean, NamesTheCandidatesOrIsEmpty) {
  EXPECT_EQ(did_you_mean("gabro", {"fourier", "gabor"}), "; did you mean 'gabor'?");
  EXPECT_EQ(did_you_mean("bin", {"bind", "bins"}), "; did you mean 'bind', 'bins'?");
  EXPECT_EQ(did_you_mean("entirely", {"gabor"}), "");
}

struct Settings {
  bool smooth = false;
  int bins = 4;
  double sigma = 0.5;
  std::string kernel = "rbf";
};

const Parameters<Settings>& settings() {
  static const auto p = Parameters<Settings>()
                            .boolean("smooth", &Settings::smooth, "smooth first")
                            .integer("bins", &Settings::bins, 1, 16, "", "bins of a channel")
                            .real("sigma", &Settings::sigma, 0, 2, "m", "noise")
                            .choice("kernel", &Settings::kernel, {"rbf", "linear"}, "kernel of the machine");
  return p;
}

const Parameter& declared(const std::string& name) {
  for (const Parameter& d : settings().declarations())
    if (d.name == name) return d;
  throw std::out_of_range(name);
}

/// A number without a range.
Parameter unlimited() {
  Parameter any = declared("sigma");
  any.minimum = -std::numeric_limits<double>::infinity();
  any.maximum = std::numeric_limits<double>::infinity();
  return any;
}

std::string complaint(const std::string& name, std::string_view text) {
  try {
    parse_parameter(declared(name), text);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

std::string complaint(const ParameterValues& given) {
  try {
    settings().read(given);
  } catch (const ConfigError& error) {
    return error.what();
  }
  return "accepted";
}

TEST(ParseParameter, ReadsEveryType) {
  for (const char* text : {"true", "on", "yes"})
    EXPECT_EQ(parse_parameter(declared("smooth"), text), ParameterValue(true));
  for (const char* text : {"false", "off", "no"})
    EXPECT_EQ(parse_parameter(declared("smooth"), text), ParameterValue(false));
  EXPECT_EQ(parse_parameter(declared("bins"), "16"), ParameterValue(std::int64_t{16}));
  EXPECT_EQ(parse_parameter(declared("bins"), "+3"), ParameterValue(std::int64_t{3}));
  EXPECT_EQ(parse_parameter(declared("bins"), "010"), ParameterValue(std::int64_t{10}));
  EXPECT_EQ(parse_parameter(declared("sigma"), "0.003"), ParameterValue(0.003));
  EXPECT_EQ(parse_parameter(declared("sigma"), "3e-3"), ParameterValue(0.003));
  EXPECT_EQ(parse_parameter(declared("sigma"), "1"), ParameterValue(1.0));
  EXPECT_EQ(parse_parameter(declared("kernel"), "linear"), ParameterValue(std::string("linear")));
}

TEST(ParseParameter, RefusesTextOfAnotherType) {
  for (const char* text : {"", "1", "True", "maybe"})
    EXPECT_EQ(complaint("smooth", text), "expected true or false, got '" + std::string(text) + "'");
  for (const char* text : {"", "+", "+-3", "four", "4.0", "4 ", " 4", "0x4", "4e0", "99999999999999999999"})
    EXPECT_EQ(complaint("bins", text), "expected an integer in [1, 16], got '" + std::string(text) + "'");
  for (const char* text : {"", "1,5", "1.5m", " 1", "nan", "inf", "+-1", "1e999"})
    EXPECT_EQ(complaint("sigma", text), "expected a number in [0, 2] m, got '" + std::string(text) + "'");
}

TEST(ParseParameter, RefusesValuesOutOfTheInclusiveRange) {
  EXPECT_EQ(complaint("bins", "1"), "accepted");
  EXPECT_EQ(complaint("bins", "16"), "accepted");
  EXPECT_EQ(complaint("bins", "0"), "expected an integer in [1, 16], got '0'");
  EXPECT_EQ(complaint("bins", "17"), "expected an integer in [1, 16], got '17'");
  EXPECT_EQ(complaint("sigma", "2"), "accepted");
  EXPECT_EQ(complaint("sigma", "2.001"), "expected a number in [0, 2] m, got '2.001'");
  EXPECT_EQ(complaint("sigma", "-1e-9"), "expected a number in [0, 2] m, got '-1e-9'");
}

TEST(ParseParameter, SuggestsAWordForAMistypedChoice) {
  EXPECT_EQ(complaint("kernel", "liner"), "expected one of rbf | linear, got 'liner'; did you mean 'linear'?");
  EXPECT_EQ(complaint("kernel", "polynomial"), "expected one of rbf | linear, got 'polynomial'");
}

/// A locale that writes numbers with a comma and groups of three, whatever locales the machine has.
class Comma final : public std::numpunct<char> {
  char do_decimal_point() const override { return ','; }
  char do_thousands_sep() const override { return '.'; }
  std::string do_grouping() const override { return "\3"; }
};

TEST(ParseParameter, DoesNotDependOnTheLocale) {
  const std::locale before = std::locale::global(std::locale(std::locale::classic(), new Comma));
  const std::string c_before = std::setlocale(LC_ALL, nullptr);
  for (const char* name : {"de_DE.UTF-8", "de_DE", "fr_FR.UTF-8"})
    if (std::setlocale(LC_ALL, name)) break;

  EXPECT_EQ(parse_parameter(declared("sigma"), "1.5"), ParameterValue(1.5));
  EXPECT_NE(complaint("sigma", "1,5"), "accepted");
  EXPECT_EQ(to_string(ParameterValue(1234567.5)), "1234567.5");
  EXPECT_EQ(to_string(ParameterValue(std::int64_t{1234567})), "1234567");
  EXPECT_EQ(range_text({"n", Parameter::Type::real, 1000.5, 0.5, 12345.25, {}, "", ""}), "[0.5, 12345.25]");

  std::setlocale(LC_ALL, c_before.c_str());
  std::locale::global(before);
}

TEST(ToString, GivesBackEveryValue) {
  for (const double value : {0.1, 1.0 / 3, -2.5e-300, 1e22, std::numeric_limits<double>::max()})
    EXPECT_EQ(parse_parameter(unlimited(), to_string(ParameterValue(value))), ParameterValue(value));
  EXPECT_EQ(parse_parameter(declared("smooth"), to_string(ParameterValue(true))), ParameterValue(true));
  EXPECT_EQ(parse_parameter(declared("bins"), to_string(ParameterValue(std::int64_t{7}))),
            ParameterValue(std::int64_t{7}));
  EXPECT_EQ(to_string(ParameterValue(std::string("rbf"))), "rbf");
}

TEST(ToString, NamesTheTypes) {
  EXPECT_EQ(to_string(Parameter::Type::boolean), "boolean");
  EXPECT_EQ(to_string(Parameter::Type::integer), "integer");
  EXPECT_EQ(to_string(Parameter::Type::real), "real");
  EXPECT_EQ(to_string(Parameter::Type::choice), "choice");
}

TEST(RangeText, SaysWhatLimitsTheValue) {
  EXPECT_EQ(range_text(declared("smooth")), "");
  EXPECT_EQ(range_text(declared("bins")), "[1, 16]");
  EXPECT_EQ(range_text(declared("sigma")), "[0, 2]");
  EXPECT_EQ(range_text(declared("kernel")), "rbf | linear");
  EXPECT_EQ(range_text(unlimited()), "");
}

TEST(Parameters, TakeTheirDefaultsFromTheStruct) {
  const Settings read = settings().read({});
  EXPECT_EQ(read.smooth, false);
  EXPECT_EQ(read.bins, 4);
  EXPECT_EQ(read.sigma, 0.5);
  EXPECT_EQ(read.kernel, "rbf");
}

TEST(Parameters, OverrideTheDefaultsWithTheGivenValues) {
  const Settings read = settings().read(
      {{"smooth", true}, {"bins", std::int64_t{9}}, {"sigma", 1.25}, {"kernel", std::string("linear")}});
  EXPECT_EQ(read.smooth, true);
  EXPECT_EQ(read.bins, 9);
  EXPECT_EQ(read.sigma, 1.25);
  EXPECT_EQ(read.kernel, "linear");
}

TEST(Parameters, CompleteKeepsEveryDeclaredName) {
  const ParameterValues values = complete(settings().declarations(), {{"bins", std::int64_t{2}}});
  EXPECT_EQ(values, (ParameterValues{
                        {"smooth", false}, {"bins", std::int64_t{2}}, {"sigma", 0.5}, {"kernel", std::string("rbf")}}));
}

TEST(Parameters, RefuseAnUnknownNameWithASuggestion) {
  EXPECT_EQ(complaint({{"bin", std::int64_t{3}}}), "unknown parameter 'bin'; did you mean 'bins'?");
  EXPECT_EQ(complaint({{"temperature", 3.0}}), "unknown parameter 'temperature'");
}

TEST(Parameters, RefuseAValueOfAnotherType) {
  EXPECT_EQ(complaint({{"bins", 4.0}}), "bins: expected an integer in [1, 16], got '4'");
  EXPECT_EQ(complaint({{"sigma", std::int64_t{1}}}), "sigma: expected a number in [0, 2] m, got '1'");
  EXPECT_EQ(complaint({{"smooth", std::string("true")}}), "smooth: expected true or false, got 'true'");
}

TEST(Parameters, RefuseAValueOutOfRange) {
  EXPECT_EQ(complaint({{"bins", std::int64_t{17}}}), "bins: expected an integer in [1, 16], got '17'");
  EXPECT_EQ(complaint({{"sigma", -0.5}}), "sigma: expected a number in [0, 2] m, got '-0.5'");
  EXPECT_EQ(complaint({{"sigma", std::nan("")}}), "sigma: expected a number in [0, 2] m, got 'nan'");
  EXPECT_EQ(complaint({{"kernel", std::string("cubic")}}), "kernel: expected one of rbf | linear, got 'cubic'");
}

}  // namespace
}  // namespace gestalt
