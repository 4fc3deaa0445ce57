// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_image.h"

#include <gtest/gtest.h>

namespace gestalt {
namespace {

cv::Mat colour_of(int depth, int channels, double value) {
  std::string problem;
  const cv::Mat colour = as_colour(cv::Mat(2, 3, CV_MAKETYPE(depth, channels), cv::Scalar::all(value)), problem);
  EXPECT_EQ(problem, "") << "depth " << depth << ", " << channels << " channels";
  return colour;
}

TEST(ColourImage, AnyTypeOfNumbersAndAnyNumberOfChannelsBecomesThreeBytes) {
  for (const int channels : {1, 3, 4})
    for (const int depth : {CV_8U, CV_8S, CV_16U, CV_16S, CV_32S, CV_32F, CV_64F}) {
      const cv::Mat colour = colour_of(depth, channels, 100);
      ASSERT_EQ(colour.type(), CV_8UC3) << "depth " << depth << ", " << channels << " channels";
      EXPECT_EQ(colour.at<cv::Vec3b>(1, 2), cv::Vec3b(100, 100, 100)) << "depth " << depth;
    }
}

TEST(ColourImage, KeepsTheOrderOfChannelsAndDropsTheFourth) {
  std::string problem;
  const cv::Mat colour = as_colour(cv::Mat(1, 1, CV_32SC4, cv::Scalar(1, 2, 3, 250)), problem);
  EXPECT_EQ(colour.at<cv::Vec3b>(0, 0), cv::Vec3b(1, 2, 3));
}

TEST(ColourImage, ValuesOfNoRangeAreAProblem) {
  for (const double value : {-1.0, 70000.0}) {
    std::string problem;
    as_colour(cv::Mat(1, 1, CV_32SC1, cv::Scalar(value)), problem);
    EXPECT_NE(problem.find("has values from"), problem.npos) << value;
  }
}

}  // namespace
}  // namespace gestalt
