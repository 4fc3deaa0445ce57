// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_depth.h"

#include <gtest/gtest.h>

#include <array>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

std::array<double, 2> border_depth(const test::KnownScene& known, bool with_border = true) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-1, -1};
  (*BorderDepth({}).bind(scene))({0, 1, with_border ? &known.surfaces.adjacencies.at(0) : nullptr}, values);
  return values;
}

TEST(BorderDepth, OfAStepIsItsHeight) {
  const auto [mean, variance] = border_depth(test::rectangle_before_wall());
  EXPECT_NEAR(mean, 0.5, 1e-6);
  EXPECT_NEAR(variance, 0, 1e-9);
}

TEST(BorderDepth, OfATiltedStepVaries) {
  // Two planes side by side, 1 m away on top and diverging with the row: the gap grows from 0 by equal steps.
  const auto scene = test::render(
      {{{100, 100, 50, 100}, {0, 0, 1}, {0, 0, -1}}, {{150, 100, 50, 100}, {0, (100 - 239.5f) / 525, 1}, {0, 1, -1}}});
  const auto [mean, variance] = border_depth(scene);
  double sum = 0, squares = 0, count = 0;
  for (const PixelPair& p : scene.surfaces.adjacencies.at(0).border_2d) {
    const double gap = std::abs(scene.frame.depth(p.a / 640, p.a % 640) - scene.frame.depth(p.b / 640, p.b % 640));
    sum += gap, squares += gap * gap, count += 1;
  }
  EXPECT_NEAR(mean, sum / count, 1e-9);
  EXPECT_NEAR(variance, squares / count - mean * mean, 1e-9);
  EXPECT_GT(variance, 1e-4);
}

TEST(BorderDepth, WithoutBorderIsZero) {
  const auto [mean, variance] = border_depth(test::rectangle_before_wall(), false);
  EXPECT_EQ(mean, 0);
  EXPECT_EQ(variance, 0);
}

}  // namespace
}  // namespace gestalt
