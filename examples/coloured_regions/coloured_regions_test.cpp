// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "coloured_regions.h"

#include <gtest/gtest.h>

namespace {

/// A wall at 1 m whose left half has one colour and whose right half another.
gestalt::Frame wall(const cv::Vec3b& left, const cv::Vec3b& right) {
  cv::Mat_<cv::Vec3b> colour(40, 60, left);
  colour(cv::Rect(30, 0, 30, 40)).setTo(right);
  return gestalt::make_frame("wall", colour, cv::Mat_<float>(40, 60, 1.0f), {60, 40, 50, 50, 29.5, 19.5});
}

TEST(ColouredRegions, TellsColoursOfOneWallApart) {
  const gestalt::PatchMap map = ColouredRegions({}).cluster(wall({200, 30, 30}, {30, 30, 200}));
  EXPECT_EQ(map.count, 2);
  EXPECT_NE(map.labels(20, 10), map.labels(20, 50));
}

TEST(ColouredRegions, ShadeIsNoBorder) {
  EXPECT_EQ(ColouredRegions({}).cluster(wall({40, 40, 80}, {80, 80, 120})).count, 1);
}

TEST(ColouredRegions, DoesWithoutColour) {
  const gestalt::Frame frame =
      gestalt::make_frame("wall", {}, cv::Mat_<float>(40, 60, 1.0f), {60, 40, 50, 50, 29.5, 19.5});
  EXPECT_EQ(ColouredRegions({}).cluster(frame).count, 1);
}

}  // namespace
