// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/result/segment_colours.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <set>
#include <tuple>

namespace gestalt {
namespace {

/// A table (label 1) with a grid of touching objects on it, 16 pixels wide each.
Segmentation grid(int rows, int columns) {
  Segmentation segmentation;
  segmentation.labels = cv::Mat_<std::uint16_t>(16 * rows + 32, 16 * columns + 32, std::uint16_t{1});
  segmentation.segments = {{{0}, 1000, Role::background}};
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      segmentation.segments.push_back({{int(segmentation.segments.size())}, 256, Role::object});
      segmentation.labels(cv::Rect(16 + 16 * column, 16 + 16 * row, 16, 16)) =
          std::uint16_t(segmentation.segments.size());
    }
  return segmentation;
}

double difference(const cv::Vec3b& a, const cv::Vec3b& b) { return cv::norm(cv::Vec3d(a) - cv::Vec3d(b)); }

TEST(SegmentColours, NeighboursDifferClearly) {
  for (const int side : {2, 4, 9}) {
    const Segmentation segmentation = grid(side, side);
    const std::vector<cv::Vec3b> colours = segment_colours(segmentation);
    for (int row = 0; row < side; ++row)
      for (int column = 0; column < side; ++column) {
        const cv::Vec3b& own = colours[std::size_t(1 + row * side + column)];
        if (column + 1 < side) {
          EXPECT_GT(difference(own, colours[std::size_t(2 + row * side + column)]), 80);
        }
        if (row + 1 < side) {
          EXPECT_GT(difference(own, colours[std::size_t(1 + (row + 1) * side + column)]), 80);
        }
      }
  }
}

TEST(SegmentColours, FewObjectsHaveDifferentColours) {
  std::set<std::tuple<int, int, int>> seen;
  for (const cv::Vec3b& colour : segment_colours(grid(2, 4))) seen.emplace(colour[0], colour[1], colour[2]);
  EXPECT_EQ(seen.size(), 9U);  // and the table
}

TEST(SegmentColours, BackgroundIsBlack) { EXPECT_EQ(segment_colours(grid(1, 1))[0], cv::Vec3b(0, 0, 0)); }

TEST(SegmentColours, AreTheSameEachTime) { EXPECT_EQ(segment_colours(grid(6, 6)), segment_colours(grid(6, 6))); }

TEST(SegmentColours, AnEmptySegmentationHasNone) { EXPECT_TRUE(segment_colours(Segmentation{}).empty()); }

}  // namespace
}  // namespace gestalt
