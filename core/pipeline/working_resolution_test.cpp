// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "working_resolution.h"

#include <gtest/gtest.h>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

/// A wall 1 m away and a square 0.3 m before it whose edges are at odd columns and rows.
test::KnownScene square_before_wall() {
  return test::render({{{0, 0, 640, 480}, {0, 0, 1}, facing}, {{201, 151, 101, 101}, {0, 0, 0.7F}, facing}});
}

TEST(Reduction, IsTheLeastThatLeavesFewEnoughPixels) {
  EXPECT_EQ(reduction({640, 480}, 0), 1);
  EXPECT_EQ(reduction({640, 480}, 640 * 480), 1);
  EXPECT_EQ(reduction({640, 480}, 640 * 480 - 1), 2);
  EXPECT_EQ(reduction({1920, 1080}, 400'000), 3);
  EXPECT_EQ(reduction({5, 3}, 1), 5);
}

TEST(Reduced, TakesDepthFromOneSideOfAJump) {
  const Frame frame = square_before_wall().frame;
  for (const int factor : {2, 3, 7}) {
    const Frame small = reduced(frame, factor);
    EXPECT_EQ(small.width(), (640 + factor - 1) / factor);
    EXPECT_EQ(small.height(), (480 + factor - 1) / factor);
    for (const float z : small.depth) EXPECT_LT(std::min(std::abs(z - 1), std::abs(z - 0.7F)), 1e-5F) << factor;
  }
}

TEST(Reduced, SeesPointsWhereTheyAre) {
  const auto known = test::render({{{0, 0, 640, 480}, {0, 0, 1}, {0.3F, 0.2F, -1}}});
  const Frame small = reduced(known.frame, 4);
  const Eigen::Vector3f normal = Eigen::Vector3f(0.3F, 0.2F, -1).normalized();
  for (int pixel = 0; pixel < int(small.depth.total()); pixel += 97)
    EXPECT_NEAR(normal.dot(small.point(pixel) - Eigen::Vector3f(0, 0, 1)), 0, 1e-4) << pixel;
}

TEST(Reduced, HasDepthWhereOnePixelHas) {
  Frame frame = square_before_wall().frame;
  frame.depth.setTo(0);
  frame.depth(101, 201) = 0.5F;
  const Frame small = reduced(frame, 4);
  EXPECT_EQ(cv::countNonZero(small.depth), 1);
  EXPECT_EQ(small.depth(25, 50), 0.5F);
}

/// What a clusterer that makes no mistake finds in the reduced frame.
Scene found_in(const Frame& small) {
  PatchMap patches{cv::Mat_<int>(small.depth.size(), 0), cv::Mat_<cv::Vec3f>(small.depth.size(), cv::Vec3f(0, 0, -1)),
                   2};
  SurfaceSet surfaces;
  surfaces.surfaces = {{{}, test::exact_plane({0, 0, 1}, facing)}, {{}, test::exact_plane({0, 0, 0.7F}, facing)}};
  for (int pixel = 0; pixel < int(small.depth.total()); ++pixel) {
    const int label = small.depth(pixel) < 0.85F ? 2 : 1;
    patches.labels(pixel) = label;
    surfaces.surfaces[std::size_t(label) - 1].pixels.push_back(pixel);
  }
  surfaces.labels = patches.labels.clone();
  return Scene(small, std::move(patches), std::move(surfaces));
}

TEST(Enlarged, FollowsEdgesOfDepthToThePixel) {
  const auto known = square_before_wall();
  for (const int factor : {2, 3, 5}) {
    const auto whole = enlarged(found_in(reduced(known.frame, factor)), known.frame, factor, {});
    const cv::Mat_<int>& labels = whole->surfaces().labels;
    for (int pixel = 0; pixel < int(labels.total()); ++pixel)
      ASSERT_EQ(labels(pixel), known.frame.depth(pixel) < 0.85F ? 2 : 1) << factor << ": " << pixel;
    EXPECT_EQ(cv::countNonZero(labels != whole->patches().labels), 0);
    EXPECT_EQ(whole->surfaces().surfaces[1].pixels.size(), 101u * 101);
    EXPECT_EQ(whole->surfaces().surfaces[1].pixels.front(), 151 * 640 + 201);
    EXPECT_EQ(whole->surfaces().adjacencies.size(), 1u);
  }
}

TEST(Enlarged, FollowsEdgesOfColourWithinAPlane) {
  auto known = test::render({{{0, 0, 640, 480}, {0, 0, 1}, facing}});
  known.frame.colour.setTo(cv::Scalar(40, 40, 200));
  known.frame.colour(cv::Rect(301, 0, 339, 480)).setTo(cv::Scalar(200, 40, 40));
  const Frame small = reduced(known.frame, 4);
  PatchMap patches{cv::Mat_<int>(small.depth.size(), 1), cv::Mat_<cv::Vec3f>(small.depth.size(), cv::Vec3f(0, 0, -1)),
                   2};
  patches.labels(cv::Rect(75, 0, 85, 120)).setTo(2);
  SurfaceSet surfaces;
  surfaces.surfaces = {{{}, test::exact_plane({0, 0, 1}, facing)}, {{}, test::exact_plane({0, 0, 1}, facing)}};
  for (int pixel = 0; pixel < int(small.depth.total()); ++pixel)
    surfaces.surfaces[std::size_t(patches.labels(pixel)) - 1].pixels.push_back(pixel);
  surfaces.labels = patches.labels.clone();
  const auto whole = enlarged(Scene(small, std::move(patches), std::move(surfaces)), known.frame, 4, {});
  EXPECT_EQ(whole->surfaces().labels(200, 300), 1);
  EXPECT_EQ(whole->surfaces().labels(200, 301), 2);
}

TEST(Enlarged, LeavesPixelsWithoutDepthAndKeepsEverySurface) {
  auto known = square_before_wall();
  known.frame.depth.setTo(0);
  known.frame.depth(101, 201) = 0.5F;   // alone in its block
  known.frame.depth(101, 205) = 0.99F;  // beside it
  Scene found = found_in(reduced(known.frame, 4));
  const auto whole = enlarged(found, known.frame, 4, {});
  EXPECT_EQ(whole->surfaces().labels(101, 201), 2);
  EXPECT_EQ(whole->surfaces().labels(101, 205), 1);
  EXPECT_EQ(whole->surfaces().labels(101, 202), 0);
  for (const Surface& surface : whole->surfaces().surfaces) EXPECT_FALSE(surface.pixels.empty());
}

}  // namespace
}  // namespace gestalt
