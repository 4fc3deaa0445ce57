// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/hypothesised_line.h"

#include <gtest/gtest.h>

#include "gestalt/core/scene/scene.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

constexpr int width = 640;

/// The line from a pixel at depth 1 m to one at depth 2 m, 10 columns and 4 rows away.
struct TwoPixels {
  test::KnownScene known =
      test::render({{{100, 100, 1, 1}, {0, 0, 1}, {0, 0, -1}}, {{110, 104, 1, 1}, {0, 0, 2}, {0, 0, -1}}});
  Scene scene{known.frame, known.patches, known.surfaces};
  const std::vector<Outline>& outlines = scene.outlines();
  HypothesisedLine there{outlines[0], 0, outlines[1], 0, width};
  HypothesisedLine back{outlines[1], 0, outlines[0], 0, width};
};

TEST(HypothesisedLine, RunsFromPixelToPixel) {
  const TwoPixels two;
  EXPECT_EQ(two.there.length(), 10);
  EXPECT_EQ(two.there.pixel(0, 10), 100 * width + 100);
  EXPECT_EQ(two.there.pixel(5, 10), 102 * width + 105);
  EXPECT_EQ(two.there.pixel(10, 10), 104 * width + 110);
}

TEST(PixelWalk, MeetsThePixelsOfTheLine) {
  const auto known = test::render({{{100, 100, 1, 1}, {0, 0, 1}, {0, 0, -1}},
                                   {{507, 3, 1, 1}, {0, 0, 2}, {0, 0, -1}},
                                   {{99, 470, 1, 1}, {0, 0, 2}, {0, 0, -1}},
                                   {{101, 101, 1, 1}, {0, 0, 2}, {0, 0, -1}}});
  const Scene scene(known.frame, known.patches, known.surfaces);
  for (const Outline& from : scene.outlines())
    for (const Outline& to : scene.outlines()) {
      const HypothesisedLine line(from, 0, to, 0, width);
      for (const int steps : {1, 2, 10, 33, 400}) {
        PixelWalk walk(line, steps);
        for (int s = 1; s <= steps; ++s) ASSERT_EQ(walk.next(), line.pixel(s, steps)) << s << " of " << steps;
      }
    }
}

TEST(HypothesisedLine, IsStraightInSpace) {
  const TwoPixels two;
  const Frame& frame = two.known.frame;
  const Eigen::Vector3f from = frame.point(100 * width + 100), to = frame.point(104 * width + 110);
  for (int s = 0; s <= 10; ++s) {
    // The point of the line that is seen at this share of the way in the image, x / z = a + s (b - a).
    const float x = (1 - s / 10.f) * from.x() / from.z() + s / 10.f * to.x() / to.z();
    const float along = (x * from.z() - from.x()) / ((to.x() - from.x()) - x * (to.z() - from.z()));
    EXPECT_NEAR(two.there.depth(s, 10), from.z() + along * (to.z() - from.z()), 1e-4) << s;
  }
}

TEST(HypothesisedLine, IsTheSameFromEitherEnd) {
  const TwoPixels two;
  for (int steps = 1; steps < 40; ++steps)
    for (int s = 0; s <= steps; ++s) {
      EXPECT_EQ(two.there.pixel(s, steps), two.back.pixel(steps - s, steps));
      EXPECT_FLOAT_EQ(two.there.depth(s, steps), two.back.depth(steps - s, steps));
    }
}

TEST(Sight, ComparesWithinNoiseAndSlack) {
  const TwoPixels two;
  const int pixel = 100 * width + 100;
  const auto tolerance = float(0.01 + 3 * two.known.frame.noise.at(1));
  EXPECT_EQ(sight(two.known.frame, pixel, 1 + 0.9f * tolerance, 0.01), Sight::level);
  EXPECT_EQ(sight(two.known.frame, pixel, 1 - 0.9f * tolerance, 0.01), Sight::level);
  EXPECT_EQ(sight(two.known.frame, pixel, 1 + 1.2f * tolerance, 0.01), Sight::front);
  EXPECT_EQ(sight(two.known.frame, pixel, 1 - 1.2f * tolerance, 0.01), Sight::behind);
  EXPECT_EQ(sight(two.known.frame, pixel + 1, 1, 0.01), Sight::unknown);
}

}  // namespace
}  // namespace gestalt
