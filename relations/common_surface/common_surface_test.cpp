// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_surface.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

std::array<double, 2> distances(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-1, -1};
  (*CommonSurface({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

TEST(CommonSurface, OfTwoPartsOfOnePlaneIsZero) {
  const Eigen::Vector3f slanted(0.2f, 0.3f, -1);
  const auto [r_sp, r_sq] =
      distances(test::render({{{100, 100, 40, 40}, {0, 0, 1}, slanted}, {{260, 110, 40, 40}, {0, 0, 1}, slanted}}));
  EXPECT_NEAR(r_sp, 0, 1e-5);
  EXPECT_NEAR(r_sq, 0, 1e-5);
}

TEST(CommonSurface, OfParallelPlanesIsTheirDistance) {
  const auto [r_sp, r_sq] = distances(test::rectangle_before_wall());
  EXPECT_NEAR(r_sp, 0.5, 1e-5);
  EXPECT_NEAR(r_sq, 0.5, 1e-5);
}

TEST(CommonSurface, IsSmallOnceWhenOnePlaneRunsThroughTheOtherPatch) {
  // A pixel in the plane of the first patch, whose own plane is tilted by 45 degrees about the vertical.
  const auto scene =
      test::render({{{300, 220, 40, 40}, {0, 0, 1}, facing}, {{400, 239, 1, 1}, {80.5f / 525, 0, 1}, {1, 0, -1}}});
  const auto [r_sp, r_sq] = distances(scene);
  EXPECT_NEAR(r_sp, 0, 1e-5);
  EXPECT_NEAR(r_sq, 80.5 / 525 / std::sqrt(2), 0.005);
}

TEST(CommonSurface, StaysWhenTheSceneMoves) {
  for (const auto& scene : {test::ridge(false), test::rectangle_before_wall()}) {
    const auto before = distances(scene), after = distances(test::moved(scene, test::some_motion()));
    EXPECT_NEAR(before[0], after[0], 1e-5);
    EXPECT_NEAR(before[1], after[1], 1e-5);
  }
}

}  // namespace
}  // namespace gestalt
