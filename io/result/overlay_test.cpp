// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <opencv2/imgproc.hpp>

#include "gestalt/io/result/result.h"
#include "gestalt/io/result/segment_colours.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const cv::Vec3b white(255, 255, 255);

/// A table (label 1) with an object (label 2) of 80 x 60 pixels on it, all of one grey.
class DrawSegments : public testing::Test {
 protected:
  DrawSegments() {
    frame_.colour = cv::Mat(240, 320, CV_8UC3, cv::Scalar::all(100));
    frame_.depth = cv::Mat_<float>(240, 320, 1.f);
    segmentation_.labels = cv::Mat_<std::uint16_t>(240, 320, std::uint16_t{1});
    segmentation_.labels(object_) = 2;
    segmentation_.segments = {{{0}, 240 * 320 - 4800, Role::background}, {{1}, 4800, Role::object}};
    tinted_ = cv::Vec3b(100, 100, 100) * 0.5 + segment_colours(segmentation_)[1] * 0.5;
  }
  cv::Vec3b drawn(int v, int u) const { return draw_segments(frame_, segmentation_).at<cv::Vec3b>(v, u); }

  const cv::Rect object_{100, 90, 80, 60};
  Frame frame_;
  Segmentation segmentation_;
  cv::Vec3b tinted_;
};

TEST_F(DrawSegments, TintsAndOutlinesObjects) {
  EXPECT_EQ(drawn(95, 110), tinted_);
  EXPECT_EQ(drawn(120, 179), white);  // its last column
  EXPECT_EQ(drawn(120, 99), white);   // the column before its first
  EXPECT_EQ(drawn(30, 30), cv::Vec3b(100, 100, 100));
}

TEST_F(DrawSegments, WritesTheLabelIntoTheObject) {
  const cv::Mat middle = draw_segments(frame_, segmentation_)(cv::Rect(125, 105, 30, 30));
  int other = 0;
  for (int v = 0; v < middle.rows; ++v)
    for (int u = 0; u < middle.cols; ++u) other += middle.at<cv::Vec3b>(v, u) != tinted_;
  EXPECT_GT(other, 20);
}

TEST_F(DrawSegments, DrawsNothingRoundBackground) {
  segmentation_.labels(cv::Rect(0, 0, 320, 40)) = 3;  // a wall
  segmentation_.segments.push_back({{2}, 320 * 40, Role::background});
  for (int u = 0; u < 320; ++u) EXPECT_EQ(drawn(39, u), cv::Vec3b(100, 100, 100)) << u;
}

TEST_F(DrawSegments, DrawsSmallGapsAsWhatIsBesideThem) {
  segmentation_.labels(95, 110) = 0;                     // in the object
  segmentation_.labels(cv::Rect(105, 130, 20, 20)) = 0;  // in the object, not small
  EXPECT_EQ(drawn(95, 110), tinted_);
  EXPECT_EQ(drawn(95, 109), tinted_);
  EXPECT_EQ(drawn(130, 104), white);
  EXPECT_EQ(drawn(140, 115), cv::Vec3b(100, 100, 100));
}

TEST_F(DrawSegments, DrawsWhatIsNoObjectAsTheCameraSeesIt) {
  for (int v = 0; v < 80; v += 7)
    for (int u = 0; u < 320; u += 5) segmentation_.labels(v, u) = 0;  // depth is missing here and there,
  segmentation_.labels(cv::Rect(240, 0, 80, 240)) = 0;                // and in a large region
  const cv::Mat picture = draw_segments(frame_, segmentation_);
  for (int v = 0; v < 240; ++v)
    for (int u = v < 85 ? 0 : 185; u < 320; ++u)
      ASSERT_EQ(picture.at<cv::Vec3b>(v, u), cv::Vec3b(100, 100, 100)) << v << ", " << u;
}

TEST_F(DrawSegments, SmallGapsGrowWithTheImage) {
  cv::resize(segmentation_.labels, segmentation_.labels, {1280, 960}, 0, 0, cv::INTER_NEAREST);
  frame_.colour = cv::Mat(960, 1280, CV_8UC3, cv::Scalar::all(100));
  segmentation_.labels(cv::Rect(420, 380, 16, 15)) = 0;
  EXPECT_EQ(drawn(385, 425), tinted_);
  EXPECT_EQ(drawn(385, 419), tinted_);
}

TEST_F(DrawSegments, DrawsAFrameWithoutSegments) {
  segmentation_.labels = 0;
  segmentation_.segments.clear();
  EXPECT_EQ(drawn(120, 160), cv::Vec3b(100, 100, 100));
}

}  // namespace
}  // namespace gestalt
