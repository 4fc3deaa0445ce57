// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contour_continuity.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

std::array<double, 2> continuity(const test::KnownScene& known, double share = 0.2) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-1, -1};
  (*ContourContinuity({share}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

const Eigen::Vector3f facing(0, 0, -1);

TEST(ContourContinuity, OfTwoPartsOfOnePlaneIsPerfect) {
  const Eigen::Vector3f slanted(0.2f, 0.3f, -1);
  const auto [r_ac, r_dn] =
      continuity(test::render({{{100, 100, 40, 40}, {0, 0, 1}, slanted}, {{160, 110, 40, 40}, {0, 0, 1}, slanted}}));
  EXPECT_NEAR(r_ac, 0, 1e-5);
  EXPECT_NEAR(r_dn, 0, 1e-5);
}

TEST(ContourContinuity, OfParallelPlanesIsTheirDistance) {
  const auto [r_ac, r_dn] =
      continuity(test::render({{{100, 100, 40, 40}, {0, 0, 1}, facing}, {{160, 100, 40, 40}, {0, 0, 1.1f}, facing}}));
  EXPECT_NEAR(r_ac, 0, 1e-5);
  EXPECT_NEAR(r_dn, 0.1, 1e-5);
}

TEST(ContourContinuity, OfTheFacesOfABoxIsTheirAngle) {
  const auto [r_ac, r_dn] = continuity(test::ridge(true));
  EXPECT_NEAR(r_ac, std::numbers::pi / 2, 1e-4);
  EXPECT_LT(r_dn, 0.05);
}

TEST(ContourContinuity, LooksAtTheNearestPointsOnly) {
  // A wall that faces the camera, and one that leaves it at the gap: near the gap the second is close to the plane of
  // the first, and the more of it counts the further it gets.
  const auto scene =
      test::render({{{280, 100, 40, 40}, {0, 0, 1}, facing}, {{322, 100, 40, 40}, {2 / 525.f, 0, 1}, {0.5f, 0, -1}}});
  EXPECT_LT(continuity(scene, 0.1)[1], continuity(scene, 0.5)[1]);
  EXPECT_LT(continuity(scene, 0.5)[1], continuity(scene, 1)[1]);
  EXPECT_NEAR(continuity(scene, 0.1)[0], std::atan(0.5), 1e-5);
}

TEST(ContourContinuity, OfSinglePixelsIsThatOfTheirPoints) {
  const auto [r_ac, r_dn] =
      continuity(test::render({{{100, 100, 1, 1}, {0, 0, 1}, facing}, {{160, 100, 1, 1}, {0, 0, 1.2f}, {1, 0, -1}}}));
  EXPECT_NEAR(r_ac, std::numbers::pi / 4, 1e-5);
  EXPECT_GT(r_dn, 0);
}

TEST(ContourContinuity, StaysWhenTheSceneMoves) {
  for (const auto& scene : {test::ridge(false), test::rectangle_before_wall()}) {
    const auto before = continuity(scene), after = continuity(test::moved(scene, test::some_motion()));
    EXPECT_NEAR(before[0], after[0], 1e-4);
    EXPECT_NEAR(before[1], after[1], 1e-4);
  }
}

}  // namespace
}  // namespace gestalt
