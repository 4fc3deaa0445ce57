// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gap_occlusion.h"

#include <gtest/gtest.h>

#include <array>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

std::array<double, 2> gap(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-9, -9};
  (*GapOcclusion({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

/// Two parts of a wall 1 m away with a strip at another depth between them.
test::KnownScene wall_with_strip(float strip, int strip_height = 40) {
  return test::render({{{100, 100, 40, 40}, {0, 0, 1}, facing},
                       {{160, 100, 40, 40}, {0, 0, 1}, facing},
                       {{140, 100, 20, strip_height}, {0, 0, strip}, facing}});
}

TEST(GapOcclusion, IsPositiveByTheDepthOfWhatCoversTheGap) {
  const auto [r_go, r_gl] = gap(wall_with_strip(0.95f));
  EXPECT_NEAR(r_go, 0.05, 1e-5);
  EXPECT_EQ(r_gl, 0);
}

TEST(GapOcclusion, IsNegativeByTheDepthOfWhatIsSeenThroughIt) {
  const auto [r_go, r_gl] = gap(wall_with_strip(1.03f));
  EXPECT_NEAR(r_go, -0.03, 1e-5);
  EXPECT_EQ(r_gl, 0);
}

TEST(GapOcclusion, IsLimited) {
  EXPECT_NEAR(gap(wall_with_strip(0.5f))[0], 0.1, 1e-6);
  EXPECT_NEAR(gap(wall_with_strip(3))[0], -0.1, 1e-6);
}

TEST(GapOcclusion, ShowsALevelThirdSurface) {
  const auto [r_go, r_gl] = gap(wall_with_strip(1.001f));
  EXPECT_NEAR(r_go, -0.001, 1e-5);
  EXPECT_EQ(r_gl, 1);
}

TEST(GapOcclusion, WithoutDepthInTheGapIsZero) {
  const auto [r_go, r_gl] =
      gap(test::render({{{100, 100, 40, 40}, {0, 0, 1}, facing}, {{160, 100, 40, 40}, {0, 0, 1}, facing}}));
  EXPECT_EQ(r_go, 0);
  EXPECT_EQ(r_gl, 0);
}

TEST(GapOcclusion, OfTouchingPatchesIsZero) {
  const auto [r_go, r_gl] = gap(test::ridge(true));
  EXPECT_EQ(r_go, 0);
  EXPECT_EQ(r_gl, 0);
}

}  // namespace
}  // namespace gestalt
