// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_surface.h"

#include <gtest/gtest.h>

#include <cmath>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

double r_sp(const test::KnownScene& known, int a = 0, int b = 1) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*CommonSurface({}).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

TEST(CommonSurface, OfTwoPartsOfOnePlaneIsZero) {
  const Eigen::Vector3f slanted(0.2f, 0.3f, -1);
  EXPECT_NEAR(r_sp(test::render({{{100, 100, 40, 40}, {0, 0, 1}, slanted}, {{260, 110, 40, 40}, {0, 0, 1}, slanted}})),
              0, 1e-5);
}

TEST(CommonSurface, OfParallelPlanesIsTheirDistance) { EXPECT_NEAR(r_sp(test::rectangle_before_wall()), 0.5, 1e-5); }

TEST(CommonSurface, IsTheSmallerOfBothWays) {
  // A pixel in the plane of the first patch, whose own plane is tilted by 45 degrees about the vertical.
  const auto scene =
      test::render({{{300, 220, 40, 40}, {0, 0, 1}, facing}, {{400, 239, 1, 1}, {80.5f / 525, 0, 1}, {1, 0, -1}}});
  EXPECT_NEAR(r_sp(scene, 0, 1), 0, 1e-5);
  EXPECT_NEAR(r_sp(scene, 1, 0), 0, 1e-5);
}

TEST(CommonSurface, OfTheFacesOfABoxIsHalfTheirWidth) {
  // A face's contour runs from the ridge, where the distance is 0, to its far end, where it is the width w of the face:
  // with a height of h the mean is that of the sides 0 and w, of length h, and of two sides from 0 to w, w / 2.
  const double far_end = 99.5 / 525, width = far_end / (1 - far_end) * std::sqrt(2.0);
  EXPECT_NEAR(r_sp(test::ridge(true)), width / 2, 0.1 * width);
}

TEST(CommonSurface, StaysWhenTheSceneMoves) {
  for (const auto& scene : {test::ridge(false), test::rectangle_before_wall()})
    EXPECT_NEAR(r_sp(scene), r_sp(test::moved(scene, test::some_motion())), 1e-5);
}

}  // namespace
}  // namespace gestalt
