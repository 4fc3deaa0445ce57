// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_curvature.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

std::array<double, 2> curvature(const test::KnownScene& known, const std::string& normals, bool with_border = true) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-9, -9};
  const Adjacency* border = with_border ? &known.surfaces.adjacencies.at(0) : nullptr;
  (*BorderCurvature({10, normals, 64}).bind(scene))({0, 1, border}, values);
  return values;
}

class BorderCurvatureOf : public testing::TestWithParam<const char*> {};

TEST_P(BorderCurvatureOf, AConvexRightAngleIsPlusHalfPi) {
  const auto [mean, variance] = curvature(test::ridge(true), GetParam());
  EXPECT_NEAR(mean, std::numbers::pi / 2, 1e-2);
  EXPECT_NEAR(variance, 0, 1e-3);
}

TEST_P(BorderCurvatureOf, AConcaveRightAngleIsMinusHalfPi) {
  const auto [mean, variance] = curvature(test::ridge(false), GetParam());
  EXPECT_NEAR(mean, -std::numbers::pi / 2, 1e-2);
  EXPECT_NEAR(variance, 0, 1e-3);
}

TEST_P(BorderCurvatureOf, AFlatBorderIsZero) {
  const auto scene = test::render(
      {{{220, 140, 100, 200}, {0, 0, 1}, {0.2f, 0, -1}}, {{320, 140, 100, 200}, {0, 0, 1}, {0.2f, 0, -1}}});
  const auto [mean, variance] = curvature(scene, GetParam());
  EXPECT_NEAR(mean, 0, 1e-2);
  EXPECT_NEAR(variance, 0, 1e-3);
}

TEST_P(BorderCurvatureOf, WithoutA3DBorderIsZero) {
  for (const bool with_border : {true, false}) {
    const auto [mean, variance] = curvature(test::rectangle_before_wall(), GetParam(), with_border);
    EXPECT_EQ(mean, 0);
    EXPECT_EQ(variance, 0);
  }
}

TEST_P(BorderCurvatureOf, OnePixelPatchesIsFinite) {
  const auto scene = test::render({{{3, 3, 1, 1}, {0, 0, 1}, {0, 0, -1}}, {{4, 3, 1, 1}, {0, 0, 1}, {1, 0, -1}}});
  const auto [mean, variance] = curvature(scene, GetParam());
  EXPECT_LE(std::abs(mean), std::numbers::pi);
  EXPECT_EQ(variance, 0);
}

INSTANTIATE_TEST_SUITE_P(Normals, BorderCurvatureOf, testing::Values("fitted", "local"));

}  // namespace
}  // namespace gestalt
