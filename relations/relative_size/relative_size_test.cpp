// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "relative_size.h"

#include <gtest/gtest.h>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

double r_rs(const test::KnownScene& known, int a, int b) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*RelativeSize({}).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

TEST(RelativeSize, IsSmallerOverLargerPixelCount) {
  const auto scene = test::render({{{0, 0, 10, 10}, {0, 0, 1}, {0, 0, -1}}, {{20, 0, 10, 40}, {0, 0, 1}, {0, 0, -1}}});
  EXPECT_DOUBLE_EQ(r_rs(scene, 0, 1), 100.0 / 400.0);
  EXPECT_DOUBLE_EQ(r_rs(scene, 1, 0), 100.0 / 400.0);
}

TEST(RelativeSize, IsOneForEqualSizes) { EXPECT_DOUBLE_EQ(r_rs(test::ridge(true), 0, 1), 1.0); }

TEST(RelativeSize, OfASinglePixelIsOneOverTheOther) {
  const auto scene = test::render({{{0, 0, 1, 1}, {0, 0, 1}, {0, 0, -1}}, {{20, 0, 5, 5}, {0, 0, 1}, {0, 0, -1}}});
  EXPECT_DOUBLE_EQ(r_rs(scene, 0, 1), 1.0 / 25.0);
}

}  // namespace
}  // namespace gestalt
