// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "centre_curvature.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

constexpr double pi = std::numbers::pi;

std::array<double, 2> curvature(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-9, -9};
  (*CentreCurvature({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

TEST(CentreCurvature, OfTheSidesOfABoxIsTheirAngle) {
  const auto [r_cc, r_cd] = curvature(test::ridge(true));
  EXPECT_NEAR(r_cc, pi / 2, 0.02);
  EXPECT_NEAR(r_cd, 0, 0.02);
}

TEST(CentreCurvature, OfTwoFacesTowardsEachOtherIsNegative) {
  EXPECT_NEAR(curvature(test::ridge(false))[0], -pi / 2, 0.02);
}

TEST(CentreCurvature, OfTwoPartsOfOnePlaneIsZero) {
  const auto [r_cc, r_cd] =
      curvature(test::render({{{100, 100, 40, 40}, {0, 0, 1}, facing}, {{160, 100, 40, 40}, {0, 0, 1}, facing}}));
  EXPECT_NEAR(r_cc, 0, 1e-4);
  EXPECT_NEAR(r_cd, 0, 1e-4);
}

TEST(CentreCurvature, OfAPlaneBehindAnotherIsPiByItsDifference) {
  // Two small patches along nearly one ray.
  const auto [r_cc, r_cd] =
      curvature(test::render({{{319, 239, 1, 1}, {0, 0, 1}, facing}, {{320, 239, 1, 1}, {0, 0, 1.5f}, facing}}));
  EXPECT_NEAR(r_cc, 0, 1e-4);
  EXPECT_NEAR(r_cd, pi, 0.02);
}

TEST(CentreCurvature, StaysWhenTheSceneMoves) {
  for (const auto& scene : {test::ridge(false), test::rectangle_before_wall()}) {
    const auto before = curvature(scene), after = curvature(test::moved(scene, test::some_motion()));
    EXPECT_NEAR(before[0], after[0], 1e-3);
    EXPECT_NEAR(before[1], after[1], 1e-3);
  }
}

}  // namespace
}  // namespace gestalt
