// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_histogram.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f before{0, 0, 1}, facing{0, 0, -1};
const cv::Vec3b black{0, 0, 0}, white{255, 255, 255};

double r_co(const test::KnownScene& known, int a, int b, int bins = 4) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*ColourHistogram({bins}).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

TEST(ColourHistogram, IsOneForEqualColoursWhateverTheSizes) {
  const auto scene = test::render({{{0, 0, 10, 10}, before, facing, white}, {{20, 0, 10, 40}, before, facing, white}});
  EXPECT_NEAR(r_co(scene, 0, 1), 1, 1e-6);
}

TEST(ColourHistogram, IsZeroForColoursWithoutACommonBin) {
  const auto scene = test::render({{{0, 0, 10, 10}, before, facing, black}, {{20, 0, 10, 10}, before, facing, white}});
  EXPECT_EQ(r_co(scene, 0, 1), 0);
}

TEST(ColourHistogram, IsTheBhattacharyyaCoefficientOfMixedColours) {
  auto scene = test::render({{{0, 0, 10, 10}, before, facing, black}, {{20, 0, 10, 10}, before, facing, white}});
  scene.frame.colour(cv::Rect(0, 0, 10, 2)).setTo(white);   // surface 0: 80 black, 20 white
  scene.frame.colour(cv::Rect(20, 0, 10, 5)).setTo(black);  // surface 1: 50 black, 50 white
  EXPECT_NEAR(r_co(scene, 0, 1), std::sqrt(0.8 * 0.5) + std::sqrt(0.2 * 0.5), 1e-6);
  EXPECT_EQ(r_co(scene, 0, 1), r_co(scene, 1, 0));
}

TEST(ColourHistogram, SeparatesNearColoursWithMoreBins) {
  const auto scene = test::render(
      {{{0, 0, 10, 10}, before, facing, {70, 70, 70}}, {{20, 0, 10, 10}, before, facing, {120, 120, 120}}});
  EXPECT_NEAR(r_co(scene, 0, 1), 1, 1e-6);
  EXPECT_EQ(r_co(scene, 0, 1, 8), 0);
}

TEST(ColourHistogram, OfSinglePixelsComparesTheirColours) {
  const auto scene = test::render({{{0, 0, 1, 1}, before, facing, white}, {{9, 0, 1, 1}, before, facing, white}});
  EXPECT_EQ(r_co(scene, 0, 1), 1);
}

TEST(ColourHistogram, NeedsColour) {
  auto known = test::ridge(true);
  known.frame.colour.release();
  EXPECT_THROW(r_co(known, 0, 1), InputError);
}

}  // namespace
}  // namespace gestalt
