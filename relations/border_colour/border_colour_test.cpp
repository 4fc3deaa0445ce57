// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "border_colour.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

double r_co3(const test::KnownScene& known, const Adjacency* border) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*BorderColour({}).bind(scene))({0, 1, border}, {&value, 1});
  return value;
}

/// 1 - distance of two colours in the UV plane over 255 sqrt(2).
double similarity(const cv::Vec3b& a, const cv::Vec3b& b) {
  cv::Mat_<cv::Vec3b> colours(1, 2), yuv;
  colours << a, b;
  cv::cvtColor(colours, yuv, cv::COLOR_BGR2YUV);
  return 1 - std::hypot(yuv(0)[1] - yuv(1)[1], yuv(0)[2] - yuv(1)[2]) / (255 * std::sqrt(2.0));
}

TEST(BorderColour, IsTheSimilarityOfTwoUniformColours) {
  const auto scene = test::ridge(true);
  ASSERT_FALSE(scene.surfaces.adjacencies.at(0).border_3d.empty());
  const double expected = similarity({40, 40, 200}, {200, 40, 40});
  EXPECT_LT(expected, 0.8);
  EXPECT_NEAR(r_co3(scene, &scene.surfaces.adjacencies[0]), expected, 1e-12);
}

TEST(BorderColour, IsOneForEqualChromaWhateverTheBrightness) {
  auto scene = test::ridge(true);
  scene.frame.colour.setTo(cv::Scalar::all(60));
  scene.frame.colour(cv::Rect(320, 0, 320, 480)).setTo(cv::Scalar::all(200));
  EXPECT_DOUBLE_EQ(r_co3(scene, &scene.surfaces.adjacencies[0]), 1);
}

TEST(BorderColour, IsTheMeanOverThe3dBorderOnly) {
  const auto scene = test::ridge(true);
  Adjacency border = scene.surfaces.adjacencies[0];
  const int left = 200 * 640 + 319;
  border.border_3d = {{left, left + 1}, {left, left}};  // one pair of both colours, one of equal ones
  EXPECT_NEAR(r_co3(scene, &border), (similarity({40, 40, 200}, {200, 40, 40}) + 1) / 2, 1e-12);
}

TEST(BorderColour, TakesThe2dBorderWhereThereIsNo3dBorder) {
  const auto scene = test::rectangle_before_wall();
  ASSERT_TRUE(scene.surfaces.adjacencies.at(0).border_3d.empty());
  EXPECT_NEAR(r_co3(scene, &scene.surfaces.adjacencies[0]), similarity({90, 90, 90}, {30, 160, 220}), 1e-12);
}

TEST(BorderColour, IsZeroWithoutABorder) { EXPECT_EQ(r_co3(test::ridge(true), nullptr), 0); }

TEST(BorderColour, StaysInRangeForTheMostDistantColours) {
  auto scene = test::ridge(true);
  scene.frame.colour.setTo(cv::Scalar(255, 0, 0));
  scene.frame.colour(cv::Rect(320, 0, 320, 480)).setTo(cv::Scalar(0, 255, 255));
  const double value = r_co3(scene, &scene.surfaces.adjacencies[0]);
  EXPECT_GE(value, 0);
  EXPECT_LT(value, 0.5);
}

}  // namespace
}  // namespace gestalt
