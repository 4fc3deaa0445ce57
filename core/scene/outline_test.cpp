// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/outline.h"

#include <gtest/gtest.h>

#include "gestalt/core/scene/scene.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

std::vector<Outline> outlines_of(const test::KnownScene& known) {
  return Scene(known.frame, known.patches, known.surfaces).outlines();
}

TEST(Outline, OfAShortContourHasAllItsPixels) {
  const auto outlines = outlines_of(test::render({{{20, 30, 10, 5}, {0, 0, 1}, facing}}));
  EXPECT_EQ(outlines.at(0).pixels.size(), 2u * (10 + 5) - 4);
}

TEST(Outline, OfALongContourIsSpreadEvenly) {
  const auto outlines = outlines_of(test::render({{{20, 30, 400, 300}, {0, 0, 1}, facing}}));
  const std::size_t contour = 2 * (400 + 300) - 4, step = 11;
  EXPECT_EQ(outlines.at(0).pixels.size(), (contour + step - 1) / step);
}

TEST(Outline, HasTheContoursOfHolesToo) {
  const auto outlines =
      outlines_of(test::render({{{20, 30, 30, 30}, {0, 0, 1}, facing}, {{30, 40, 2, 2}, {0, 0, 0.9f}, facing}}));
  // The pixels around a hole of 2 x 2, without its corners, which no 8-connected walk needs.
  EXPECT_EQ(outlines.at(0).pixels.size(), ((4u * 30 - 4) + 4 * 2));
}

TEST(Outline, LiesOnTheFittedSurface) {
  test::KnownScene known = test::render({{{20, 30, 40, 40}, {0, 0, 1}, {0.3f, 0, -1}}});
  known.frame.points(30, 20)[2] += 0.01f;  // a noisy corner
  const Outline outline = outlines_of(known).at(0);
  const Eigen::Vector3f normal = Eigen::Vector3f(0.3f, 0, -1).normalized();
  for (Eigen::Index i = 0; i < outline.points.cols(); ++i) {
    EXPECT_NEAR(normal.dot(outline.points.col(i) - Eigen::Vector3f(0, 0, 1)), 0, 1e-6);
    EXPECT_NEAR((outline.normals.col(i) - normal).norm(), 0, 1e-6);
  }
}

TEST(Outline, OfOnePixelIsThatPixel) {
  const auto outlines = outlines_of(test::render({{{3, 2, 1, 1}, {0, 0, 1}, facing}}));
  EXPECT_EQ(outlines.at(0).pixels, std::vector<int>{2 * 640 + 3});
}

TEST(NearestPoints, AreTheNearestShareAndTheFirstOfEquals) {
  Eigen::Matrix3Xf from(3, 4), to(3, 3);
  from << 0, 1, 2, 3, /**/ 0, 0, 0, 0, /**/ 0, 0, 0, 0;
  to << 5, 4, 4, /**/ 0, 0, 0, /**/ 0, 0, 0;
  const auto half = nearest_points(from, to, 0.5);
  ASSERT_EQ(half.size(), 2u);
  for (const NearestPoint& point : half) {
    EXPECT_GE(point.from, 2);
    EXPECT_EQ(point.to, 1);
    EXPECT_EQ(point.squared_distance, float((4 - point.from) * (4 - point.from)));
  }
  EXPECT_EQ(nearest_points(from, to, 1e-6).size(), 1u);
  EXPECT_EQ(nearest_points(from, to, 1).size(), 4u);
}

TEST(SpreadColumns, AreEvenlySpreadOrAll) {
  const auto outlines = outlines_of(test::render({{{20, 30, 10, 5}, {0, 0, 1}, facing}}));
  EXPECT_EQ(spread_columns(outlines.at(0), 13), (std::vector<int>{0, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 22, 24}));
  EXPECT_EQ(spread_columns(outlines.at(0), 100).size(), 26u);
}

}  // namespace
}  // namespace gestalt
