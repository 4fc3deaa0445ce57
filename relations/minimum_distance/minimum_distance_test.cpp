// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "minimum_distance.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

double r_md(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*MinimumDistance({}).bind(scene))({0, 1, nullptr}, {&value, 1});
  return value;
}

const Eigen::Vector3f facing(0, 0, -1);

TEST(MinimumDistance, AcrossAGapIsItsWidth) {
  // Columns 100..129 and 150..179 of a wall 1 m away: 21 pixels from edge to edge.
  const auto scene = test::render({{{100, 100, 30, 30}, {0, 0, 1}, facing}, {{150, 100, 30, 30}, {0, 0, 1}, facing}});
  EXPECT_NEAR(r_md(scene), 21 / 525.0, 1e-5);
}

TEST(MinimumDistance, OfDiagonalPatchesRunsFromCornerToCorner) {
  const auto scene = test::render({{{100, 100, 30, 30}, {0, 0, 1}, facing}, {{132, 133, 30, 30}, {0, 0, 1}, facing}});
  EXPECT_NEAR(r_md(scene), 5 / 525.0, 1e-5);
}

TEST(MinimumDistance, AcrossADepthJumpIsThatJump) {
  const auto scene =
      test::render({{{100, 100, 30, 30}, {0, 0, 1}, facing}, {{130, 100, 30, 30}, {0, 0, 1.3f}, facing}});
  EXPECT_NEAR(r_md(scene), 0.3, 0.005);
}

TEST(MinimumDistance, OfLongContoursIsWithinItsBound) {
  // A contour of 1396 pixels of which every eleventh is taken, against a single pixel 10 px beside it.
  const auto scene = test::render({{{20, 30, 400, 300}, {0, 0, 1}, facing}, {{429, 151, 1, 1}, {0, 0, 1}, facing}});
  EXPECT_GE(r_md(scene), 10 / 525.0 - 1e-6);
  EXPECT_LE(r_md(scene), std::hypot(10, 5.5) / 525);
}

TEST(MinimumDistance, StaysWhenTheSceneMoves) {
  const auto scene = test::ridge(true), other = test::rectangle_before_wall();
  EXPECT_NEAR(r_md(test::moved(scene, test::some_motion())), r_md(scene), 1e-5);
  EXPECT_NEAR(r_md(test::moved(other, test::some_motion())), r_md(other), 1e-5);
}

}  // namespace
}  // namespace gestalt
