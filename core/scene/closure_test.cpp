// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/closure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "gestalt/core/scene/scene.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

std::vector<Closure> closures_of(const std::vector<test::PlanarPatch>& patches) {
  const test::KnownScene known = test::render(patches);
  const Scene scene(known.frame, known.patches, known.surfaces);
  return scene.closures();
}

/// Area on the left of a polygon, in px^2.
double area(const Closure& closure) {
  double sum = 0;
  for (std::size_t i = 0; i < closure.outline.size(); ++i) {
    const Eigen::Vector2d a = closure.outline[i].cast<double>();
    const Eigen::Vector2d b = closure.outline[(i + 1) % closure.outline.size()].cast<double>();
    sum -= a.x() * b.y() - a.y() * b.x();
  }
  return sum / 2;
}

TEST(Closures, OfASquareInTwoHalvesIsTheSquare) {
  const auto closures =
      closures_of({{{200, 150, 60, 120}, {0, 0, 1}, facing}, {{260, 150, 60, 120}, {0, 0, 1}, facing}});
  ASSERT_FALSE(closures.empty());
  const Closure& square = closures.front();
  EXPECT_NEAR(area(square), 119 * 119, 5);
  EXPECT_EQ(square.lines.size(), 6u);
  EXPECT_NEAR(square.line_length, 4 * 119 - 2, 1);
  EXPECT_NEAR(square.gap_length, 2, 1);
  ASSERT_EQ(square.parts.size(), 2u);
  for (const Closure::Part& part : square.parts) {
    EXPECT_NEAR(part.line_length, 59 + 119 + 59, 1);
    EXPECT_GT(part.inside, 0.95);
  }
}

TEST(Closures, BridgeAnOccluder) {
  const auto closures = closures_of({{{100, 200, 200, 80}, {0, 0, 1}, facing},
                                     {{340, 200, 200, 80}, {0, 0, 1}, facing},
                                     {{300, 150, 40, 180}, {0, 0, 0.8f}, facing}});
  const auto bar = std::find_if(closures.begin(), closures.end(), [](const Closure& closure) {
    return closure.parts.size() == 2 && closure.parts[0].surface == 0 && closure.parts[1].surface == 1;
  });
  ASSERT_NE(bar, closures.end());
  EXPECT_NEAR(area(*bar), 439 * 79, 50);
  EXPECT_NEAR(bar->gap_length, 82, 1);
}

TEST(Closures, AreOfTwoSurfacesAndConvex) {
  // An arrow's head beside its shaft, a square of its own, and one in two halves.
  const auto closures = closures_of({{{100, 200, 150, 40}, {0, 0, 1}, facing},
                                     {{250, 150, 60, 140}, {0, 0, 1}, facing},
                                     {{500, 100, 60, 60}, {0, 0, 1}, facing},
                                     {{400, 320, 60, 120}, {0, 0, 1}, facing},
                                     {{460, 320, 60, 120}, {0, 0, 1}, facing}});
  ASSERT_FALSE(closures.empty());
  for (const Closure& closure : closures) {
    EXPECT_GE(closure.parts.size(), 2u);
    EXPECT_GT(area(closure), 0);
    EXPECT_LE(closure.gap_length, 2 * closure.line_length);
    double turned = 0;
    for (std::size_t i = 0; i < closure.outline.size(); i += 2) {
      const Eigen::Vector2f along = closure.outline[i + 1] - closure.outline[i];
      const Eigen::Vector2f next =
          closure.outline[(i + 3) % closure.outline.size()] - closure.outline[(i + 2) % closure.outline.size()];
      const double turn = -std::atan2(along.x() * next.y() - along.y() * next.x(), along.dot(next));
      EXPECT_GT(turn, -0.2);
      turned += turn;
    }
    EXPECT_NEAR(turned, 2 * std::acos(-1.0), 1e-3) << "once around";
  }
}

TEST(Closures, OfAnOpenContourAreNone) {
  // Two halves of a bar that runs out of the image on both sides.
  EXPECT_TRUE(closures_of({{{0, 200, 300, 80}, {0, 0, 1}, facing}, {{340, 200, 300, 80}, {0, 0, 1}, facing}}).empty());
}

TEST(Closures, OfOneSurfaceOrOfSpecksAreNone) {
  EXPECT_TRUE(closures_of({{{100, 200, 200, 80}, {0, 0, 1}, facing}}).empty());
  EXPECT_TRUE(closures_of({{{10, 10, 1, 1}, {0, 0, 1}, facing}, {{20, 10, 1, 1}, {0, 0, 1}, facing}}).empty());
}

TEST(Closures, OfThousandsOfSurfacesAreBounded) {
  std::vector<test::PlanarPatch> patches;
  for (int row = 0; row < 40; ++row)
    for (int column = 0; column < 50; ++column)
      patches.push_back({{column * 12 + 5, row * 12, 11, 11}, {0, 0, 1}, facing});
  const auto closures = closures_of(patches);
  EXPECT_LE(closures.size(), 256u);
  EXPECT_FALSE(closures.empty());
}

}  // namespace
}  // namespace gestalt
