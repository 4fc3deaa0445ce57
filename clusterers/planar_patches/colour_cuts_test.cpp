// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_cuts.h"

#include <gtest/gtest.h>

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <random>

#include "colour_edges.h"
#include "gestalt/core/base/thread_limit.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const cv::Vec3b red{40, 40, 200}, blue{200, 60, 40};

/// A square of 160 pixels, 0.3 m, seen from the front, in a frame that shows nothing else.
test::KnownScene square() { return test::render({{{200, 150, 160, 160}, {0, 0, 1}, {0, 0, -1}, red}}); }

ColourCutParams with_share(double share) {
  ColourCutParams params;
  params.cut_share = share;
  return params;
}

CutPatches cut(const test::KnownScene& scene, const ColourCutParams& params = with_share(0.8)) {
  return cut_along_colour_edges(scene.frame, {scene.patches.labels.clone(), scene.patches.count}, params);
}

TEST(ColourEdges, HaveTheStrengthAndDirectionOfAStep) {
  cv::Mat image(40, 60, CV_8UC3, cv::Scalar::all(50));
  image(cv::Rect(30, 0, 30, 40)).setTo(cv::Scalar::all(150));
  const ColourEdges edges = find_colour_edges(image, 1);
  EXPECT_GT(edges.strength(20, 29) + edges.strength(20, 30), 6);
  EXPECT_EQ(cv::countNonZero(edges.strength.row(20)), 1);
  EXPECT_NEAR(std::sin(edges.direction(20, 30)), 0, 1e-3);  // to the right or to the left
  const ColourEdges turned = find_colour_edges(image.t(), 1);
  EXPECT_NEAR(turned.direction(30, 20), std::acos(0.0), 1e-3);
}

TEST(ColourCuts, CutAPlaneWhereItsColourChangesAllAcross) {
  test::KnownScene scene = square();
  scene.frame.colour(cv::Rect(200, 150, 60, 160)).setTo(blue);
  const auto [patches, grown] = cut(scene);
  ASSERT_EQ(patches.count, 2);
  EXPECT_EQ(grown, (std::vector<int>{1, 1}));
  for (const int v : {150, 230, 309}) {
    EXPECT_EQ(patches.labels(v, 200), patches.labels(v, 257));
    EXPECT_EQ(patches.labels(v, 263), patches.labels(v, 359));
    EXPECT_NE(patches.labels(v, 257), patches.labels(v, 263));
  }
  EXPECT_EQ(cv::countNonZero(patches.labels), 160 * 160);
  EXPECT_EQ(patches.labels(10, 10), 0);
}

TEST(ColourCuts, CutAlongSlantedLines) {
  test::KnownScene scene = square();
  for (int v = 0; v < 160; ++v) scene.frame.colour(cv::Rect(200, 150 + v, 50 + v / 3, 1)).setTo(blue);
  const auto [patches, grown] = cut(scene);
  ASSERT_EQ(patches.count, 2);
  int wrong = 0;
  for (int v = 0; v < 160; ++v)
    for (int u = 0; u < 160; ++u)
      wrong += (patches.labels(150 + v, 200 + u) == patches.labels(150, 200)) != (u < 50 + v / 3);
  EXPECT_LT(wrong, 160 * 4);
}

TEST(ColourCuts, CutPartsAgain) {
  test::KnownScene scene = square();
  scene.frame.colour(cv::Rect(200, 150, 50, 160)).setTo(blue);
  scene.frame.colour(cv::Rect(310, 150, 50, 160)).setTo(blue);
  EXPECT_EQ(cut(scene).patches.count, 3);
}

TEST(ColourCuts, LeavePrintInsideAPatchAlone) {
  test::KnownScene scene = square();
  scene.frame.colour(cv::Rect(250, 200, 60, 60)).setTo(blue);
  EXPECT_EQ(cut(scene).patches.count, 1);
}

TEST(ColourCuts, LeaveShadesAndNoiseAlone) {
  test::KnownScene scene = square();
  std::mt19937 random(1);
  for (int v = 0; v < 480; ++v)
    for (int u = 0; u < 640; ++u)
      scene.frame.colour.at<cv::Vec3b>(v, u) = cv::Vec3b::all(std::uint8_t(60 + u / 8 + int(random() % 12)));
  EXPECT_EQ(cut(scene).patches.count, 1);
}

TEST(ColourCuts, KeepToTheirLimits) {
  test::KnownScene scene = square();
  scene.frame.colour(cv::Rect(200, 150, 60, 160)).setTo(blue);
  ColourCutParams params = with_share(0.8);
  params.longest_cut = 0.2;  // the line is 0.3 m long
  EXPECT_EQ(cut(scene, params).patches.count, 1);
  params = with_share(0.8);
  params.cut_width = 65;
  EXPECT_EQ(cut(scene, params).patches.count, 1);
  params = with_share(0.8);
  params.cut_length = 170;
  EXPECT_EQ(cut(scene, params).patches.count, 1);
  params = with_share(0.8);
  params.cut_contrast = 90;
  EXPECT_EQ(cut(scene, params).patches.count, 1);
}

TEST(ColourCuts, NeedAnEdgeAlongTheirShare) {
  test::KnownScene scene = square();
  scene.frame.colour(cv::Rect(200, 150, 60, 100)).setTo(blue);  // its edge reaches five eighths of the way down
  EXPECT_EQ(cut(scene, with_share(0.55)).patches.count, 3);     // then the lower end cuts the left part
  EXPECT_EQ(cut(scene, with_share(0.8)).patches.count, 1);
}

TEST(ColourCuts, AreTheSameForAnyNumberOfThreads) {
  std::vector<test::PlanarPatch> squares;
  for (int i = 0; i < 12; ++i)
    squares.push_back(
        {{20 + 150 * (i % 4), 20 + 150 * (i / 4), 100, 100}, {0, 0, 1 + 0.1f * float(i)}, {0, 0, -1}, red});
  test::KnownScene scene = test::render(squares);
  for (int i = 0; i < 12; ++i)
    scene.frame.colour(cv::Rect(20 + 150 * (i % 4), 20 + 150 * (i / 4), 30 + 4 * i, 100)).setTo(blue);
  const auto run = [&](int threads) {
    const ThreadLimit limit(threads);
    return cut(scene);
  };
  const CutPatches one = run(1), two = run(2);
  EXPECT_EQ(one.patches.count, 24);
  EXPECT_EQ(one.grown, two.grown);
  EXPECT_EQ(cv::countNonZero(one.patches.labels != two.patches.labels), 0);
}

}  // namespace
}  // namespace gestalt
