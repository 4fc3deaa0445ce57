// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "collinearity.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

/// r_cs and r_oc of the first two surfaces.
std::array<double, 2> collinearity(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-9, -9};
  (*Collinearity({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

const test::PlanarPatch left{{100, 200, 200, 80}, {0, 0, 1}, facing};
const test::PlanarPatch right{{340, 200, 200, 80}, {0, 0, 1}, facing};

test::PlanarPatch pole(float depth) { return {{300, 150, 40, 180}, {0, 0, depth}, facing}; }

TEST(Collinearity, OfABarBehindAPoleIsStraightAndCovered) {
  const auto [continuity, occlusion] = collinearity(test::render({left, right, pole(0.8f)}));
  EXPECT_NEAR(continuity, 0, 0.01);
  EXPECT_NEAR(occlusion, 0.2, 1e-3);
}

TEST(Collinearity, OfTwoThingsInLineBeforeAWallIsNotCovered) {
  const auto [continuity, occlusion] = collinearity(test::render({left, right, pole(1.5f)}));
  EXPECT_NEAR(continuity, 0, 0.01);
  EXPECT_NEAR(occlusion, -0.5, 1e-3);
}

TEST(Collinearity, OfATiltedBarIsStraightToo) {
  const auto tilted = [](test::PlanarPatch patch) {
    patch.normal = {0.5f, 0, -1};
    return patch;
  };
  const auto [continuity, occlusion] = collinearity(test::render({tilted(left), tilted(right), pole(0.6f)}));
  EXPECT_NEAR(continuity, 0, 0.01);
  // The line is 1 m away in the middle, where its depth hardly differs from its mean.
  EXPECT_NEAR(occlusion, 0.4, 0.01);
}

TEST(Collinearity, OfABarSetBackCountsTheOffset) {
  test::PlanarPatch back = right;
  back.point.z() = 1.05f;
  const auto [continuity, occlusion] = collinearity(test::render({left, back, pole(0.8f)}));
  // 50 mm back, and for the nearer edge a little off the optical axis: 50.0 to 50.2 mm, of 100 for a right angle.
  EXPECT_NEAR(continuity, 0.5, 0.005);
  EXPECT_NEAR(occlusion, 0.225, 0.002);
}

TEST(Collinearity, OfABarBentInDepthCountsTheAngle) {
  // The right half turns away by 30 degrees, about the vertical through the middle of the gap at 1 m.
  test::PlanarPatch bent = right;
  bent.normal = {std::tan(30 * 3.14159265f / 180), 0, -1};
  const auto [continuity, occlusion] = collinearity(test::render({left, bent, pole(0.8f)}));
  // Edges above the optical axis run up or down in 3D by a little as well.
  EXPECT_GT(continuity, 0.3);
  EXPECT_LT(continuity, 0.6);
  EXPECT_GT(occlusion, 0.2);
}

TEST(Collinearity, OfThingsOutOfLineIsTheFixedValue) {
  test::PlanarPatch above = right;
  above.pixels.y = 20;
  const auto [continuity, occlusion] = collinearity(test::render({left, above, pole(0.8f)}));
  EXPECT_EQ(continuity, 2);
  EXPECT_EQ(occlusion, -1);
}

TEST(Collinearity, DoesNotChangeWhenTheSceneTurnsAboutTheOpticalAxis) {
  const Camera square{480, 480, 525, 525, 239.5, 239.5};
  const auto upright = collinearity(test::render({{{60, 200, 150, 80}, {0, 0, 1}, facing},
                                                  {{250, 200, 150, 80}, {0, 0, 1.03f}, facing},
                                                  {{210, 150, 40, 180}, {0, 0, 0.8f}, facing}},
                                                 square));
  const auto turned = collinearity(test::render({{{200, 60, 80, 150}, {0, 0, 1}, facing},
                                                 {{200, 250, 80, 150}, {0, 0, 1.03f}, facing},
                                                 {{150, 210, 180, 40}, {0, 0, 0.8f}, facing}},
                                                square));
  EXPECT_NEAR(upright[0], turned[0], 1e-3);
  EXPECT_NEAR(upright[1], turned[1], 1e-3);
}

TEST(Collinearity, OfOneRowOrOnePixelIsFinite) {
  for (const cv::Rect& pixels : {cv::Rect(340, 200, 60, 1), cv::Rect(340, 200, 1, 60), cv::Rect(340, 200, 1, 1)}) {
    const auto [continuity, occlusion] = collinearity(test::render({left, {pixels, {0, 0, 1}, facing}}));
    EXPECT_GE(continuity, 0);
    EXPECT_LE(continuity, 2);
    EXPECT_LE(std::abs(occlusion), 1);
  }
}

}  // namespace
}  // namespace gestalt
