// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "cuts.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace gestalt {
namespace {

Parameter real(double low, double high) { return {"k", Parameter::Type::real, 0.5, low, high, {}, "", ""}; }

void expect_sound(const std::vector<double>& values, const Parameter& parameter, double current) {
  EXPECT_TRUE(std::is_sorted(values.begin(), values.end()));
  EXPECT_EQ(std::adjacent_find(values.begin(), values.end()), values.end());
  EXPECT_GE(values.front(), parameter.minimum);
  EXPECT_LE(values.back(), parameter.maximum);
  EXPECT_EQ(std::count(values.begin(), values.end(), current), 1);
}

TEST(SweepValues, CoverASmallRangeEvenly) {
  const std::vector<double> values = sweep_values(real(0, 1), 0.72);
  expect_sound(values, real(0, 1), 0.72);
  EXPECT_EQ(values.size(), 62u);
  EXPECT_EQ(values.front(), 0);
  EXPECT_EQ(values.back(), 1);
  EXPECT_EQ(values[1], 0.01667);
  EXPECT_EQ(sweep_values(real(0, 1), 0.5).size(), 61u);
}

TEST(SweepValues, GoToBothSidesOfTheCurrentValueInALargeRange) {
  const std::vector<double> values = sweep_values(real(0, 1e9), 0.5);
  expect_sound(values, real(0, 1e9), 0.5);
  EXPECT_EQ(values.front(), 0);
  EXPECT_NEAR(values[1], 0.5 / 32, 1e-5);
  EXPECT_EQ(values.back(), 16);
}

TEST(SweepValues, AreThereForZeroAndForTheEndsOfTheRange) {
  expect_sound(sweep_values(real(0, 1e9), 0), real(0, 1e9), 0);
  EXPECT_EQ(sweep_values(real(0, 1e9), 0).back(), 32);
  expect_sound(sweep_values(real(0, 100), 100), real(0, 100), 100);
  EXPECT_EQ(sweep_values(real(0, 100), 100).back(), 100);
  expect_sound(sweep_values(real(-1e9, 1e9), -3), real(-1e9, 1e9), -3);
}

TEST(CutOf, GivesEachPatchItsLabel) {
  Segmentation segmentation;
  segmentation.segments = {{{0, 3}, 10, Role::background}, {{1}, 5, Role::object}};
  EXPECT_EQ(cut_of(segmentation, 4), (Cut{{1, 2, 0, 1}, {Role::background, Role::object}}));
}

}  // namespace
}  // namespace gestalt
