// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "joint_extent.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

double r_ex(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*JointExtent({}).bind(scene))({0, 1, nullptr}, {&value, 1});
  return value;
}

TEST(JointExtent, IsTheDistanceOfTheFarthestPixels) {
  const auto scene = test::render({{{100, 100, 1, 1}, {0, 0, 1}, facing}, {{130, 140, 1, 1}, {0, 0, 1}, facing}});
  EXPECT_NEAR(r_ex(scene), 50 / 525.0, 1e-5);
}

TEST(JointExtent, RunsFromCornerToCornerOfLargerPatches) {
  // From column 100 to 199 and row 100 to 139; contours of 156 pixels, of which every third or fourth is taken.
  const auto scene = test::render({{{100, 100, 40, 40}, {0, 0, 1}, facing}, {{160, 100, 40, 40}, {0, 0, 1}, facing}});
  EXPECT_LE(r_ex(scene), std::hypot(99, 39) / 525 + 1e-6);
  EXPECT_GE(r_ex(scene), (std::hypot(99, 39) - 4) / 525);
}

TEST(JointExtent, IsThatOfTheLargerForAPatchInItsMiddle) {
  const auto scene = test::render({{{100, 100, 41, 41}, {0, 0, 1}, facing}, {{120, 120, 1, 1}, {0, 0, 1}, facing}});
  EXPECT_NEAR(r_ex(scene), std::hypot(20, 20) / 525, 2 / 525.0);
}

TEST(JointExtent, StaysWhenTheSceneMoves) {
  for (const auto& scene : {test::ridge(true), test::rectangle_before_wall()})
    EXPECT_NEAR(r_ex(test::moved(scene, test::some_motion())), r_ex(scene), 1e-5);
}

}  // namespace
}  // namespace gestalt
