// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_height.h"

#include <gtest/gtest.h>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

double r_th(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*CommonHeight({}).bind(scene))({0, 1, nullptr}, {&value, 1});
  return value;
}

/// A level floor 0.5 m below the camera, and two upright plates 1 m away that cover rows of their columns.
test::KnownScene plates(int top_a, int bottom_a, int top_b, int bottom_b) {
  return test::render({{{200, top_a, 30, bottom_a - top_a}, {0, 0, 1}, facing},
                       {{300, top_b, 30, bottom_b - top_b}, {0, 0, 1}, facing},
                       {{0, 440, 640, 40}, {0, 0.5f, 0}, {0, -1, 0}}});
}

TEST(CommonHeight, OfPlatesOfOneHeightIsZero) { EXPECT_NEAR(r_th(plates(100, 200, 100, 200)), 0, 1e-6); }

TEST(CommonHeight, DiffersByRowsWhereThePlatesDo) {
  // Moved by 20 rows as a whole, at 1 m.
  EXPECT_NEAR(r_th(plates(100, 200, 120, 220)), 20 / 525.0, 1e-5);
  // 100 rows longer at the bottom: the upper three percent of that do not count.
  EXPECT_NEAR(r_th(plates(100, 200, 100, 300)), 0.03 * 100 / 525, 2 / 525.0);
}

TEST(CommonHeight, RunsAlongTheNormalOfTheLargestPatch) {
  // Without a floor the plates are compared along the normal of the larger one, so that only depth counts.
  EXPECT_NEAR(
      r_th(test::render({{{200, 100, 30, 100}, {0, 0, 1}, facing}, {{300, 120, 30, 90}, {0, 0, 1.2f}, facing}})), 0.2,
      1e-6);
}

TEST(CommonHeight, StaysWhenTheSceneMoves) {
  const auto scene = plates(100, 200, 120, 260);
  EXPECT_NEAR(r_th(test::moved(scene, test::some_motion())), r_th(scene), 1e-5);
}

}  // namespace
}  // namespace gestalt
