// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "hull_view.h"

#include <gtest/gtest.h>

#include <array>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

std::array<double, 4> view(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 4> values{-9, -9, -9, -9};
  (*HullView({}).bind(scene))({0, 1, nullptr}, values);
  return values;
}

/// Two parts of a wall 1 m away, 61 pixels apart and each 20 wide, with a plane at another depth between them.
test::KnownScene parts(float between) {
  return test::render({{{100, 100, 20, 40}, {0, 0, 1}, facing},
                       {{180, 100, 20, 40}, {0, 0, 1}, facing},
                       {{120, 100, 60, 40}, {0, 0, between}, facing}});
}

TEST(HullView, OfPartsOfOneSurfaceThatIsCoveredIsFull) {
  const auto [r_hb, r_ho, r_hn, r_hh] = view(parts(0.9f));
  EXPECT_EQ(r_hb, 0);
  EXPECT_EQ(r_ho, 0);
  EXPECT_EQ(r_hn, 0);
  EXPECT_EQ(r_hh, 0);
}

TEST(HullView, OfThingsApartIsEmptyBetweenThem) {
  // Three fifths of the 100 columns, a little more for lines that do not begin at the outer side.
  const auto [r_hb, r_ho, r_hn, r_hh] = view(parts(1.5f));
  EXPECT_GT(r_hb, 0.6);
  EXPECT_LT(r_hb, 1);
  EXPECT_EQ(r_ho, r_hb);
  EXPECT_EQ(r_hn, 1);
  EXPECT_EQ(r_hh, 0);
}

TEST(HullView, TellsTheInsideFromTheOutside) {
  // The lines are at most 108 px = 0.21 m long: what is seen 0.03 m behind them may be the inside of an object.
  const auto [r_hb, r_ho, r_hn, r_hh] = view(parts(1.03f));
  EXPECT_GT(r_hb, 0.6);
  EXPECT_LT(r_ho, 0.1 * r_hb);
}

TEST(HullView, SeesTheHollowBetweenFacesThatFaceEachOther) {
  const auto concave = view(test::ridge(false)), convex = view(test::ridge(true));
  EXPECT_GT(concave[3], 0.25);
  EXPECT_EQ(convex[3], 0);
  EXPECT_EQ(concave[0], 0);
  EXPECT_EQ(convex[0], 0);
}

TEST(HullView, WithoutDepthBetweenIsZero) {
  const auto values =
      view(test::render({{{100, 100, 20, 40}, {0, 0, 1}, facing}, {{180, 100, 20, 40}, {0, 0, 1}, facing}}));
  EXPECT_EQ(values, (std::array<double, 4>{0, 0, 0, 0}));
}

}  // namespace
}  // namespace gestalt
