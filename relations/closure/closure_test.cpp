// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "closure.h"

#include <gtest/gtest.h>

#include <array>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

/// r_ls, r_as and r_lg of the first two surfaces.
std::array<double, 3> closure(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 3> values{-9, -9, -9};
  (*ClosureRelation({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

const test::PlanarPatch left{{100, 200, 200, 80}, {0, 0, 1}, facing};
const test::PlanarPatch right{{340, 200, 200, 80}, {0, 0, 1}, facing};

TEST(ClosureRelation, OfABarBehindAPoleExplainsItAll) {
  const auto [lines, area, gaps] = closure(test::render({left, right, {{300, 150, 40, 180}, {0, 0, 0.8f}, facing}}));
  EXPECT_NEAR(lines, 1, 0.03) << "the sides at the pole are the pole's";
  EXPECT_GT(area, 0.97);
  // Two gaps of 41 px, and on either side two lines of 199 px and one of 79.
  EXPECT_NEAR(gaps, 82.0 / (82 + 2 * (199 + 199 + 79)), 0.003);
}

TEST(ClosureRelation, CountsTheBoundaryThatItLeavesOut) {
  // Nothing hides what would be between the two, so their inner sides are boundary, and not in the closure.
  const auto [lines, area, gaps] = closure(test::render({left, right}));
  EXPECT_NEAR(lines, (199.0 + 199 + 79) / (2 * (199 + 79)), 0.03);
  EXPECT_GT(area, 0.97);
  EXPECT_LT(gaps, 0.1);
}

TEST(ClosureRelation, WithoutOneHasFixedValues) {
  // Both run out of the image: an open contour.
  const auto [lines, area, gaps] =
      closure(test::render({{{0, 200, 300, 80}, {0, 0, 1}, facing}, {{340, 200, 300, 80}, {0, 0, 1}, facing}}));
  EXPECT_EQ(lines, 0);
  EXPECT_EQ(area, 0);
  EXPECT_EQ(gaps, 1);
}

TEST(ClosureRelation, OfThingsFarApartIsNone) {
  // The gaps between the two would be longer than twice the lines.
  const auto [lines, area, gaps] =
      closure(test::render({{{20, 20, 40, 40}, {0, 0, 1}, facing}, {{560, 20, 40, 40}, {0, 0, 1}, facing}}));
  EXPECT_EQ(lines, 0);
  EXPECT_EQ(area, 0);
  EXPECT_EQ(gaps, 1);
}

TEST(ClosureRelation, DoesNotChangeWhenTheSceneTurnsAboutTheOpticalAxis) {
  const Camera square{480, 480, 525, 525, 239.5, 239.5};
  const auto upright = closure(
      test::render({{{60, 200, 150, 80}, {0, 0, 1}, facing}, {{250, 200, 150, 80}, {0, 0, 1}, facing}}, square));
  const auto turned = closure(
      test::render({{{200, 60, 80, 150}, {0, 0, 1}, facing}, {{200, 250, 80, 150}, {0, 0, 1}, facing}}, square));
  EXPECT_NEAR(upright[0], turned[0], 1e-3);
  EXPECT_NEAR(upright[1], turned[1], 0.02);
  EXPECT_NEAR(upright[2], turned[2], 1e-3);
}

}  // namespace
}  // namespace gestalt
