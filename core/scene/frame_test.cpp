// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/frame.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "gestalt/core/base/error.h"
#include "gestalt/core/scene/scene.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

cv::Mat_<float> metre(int width = 4, int height = 3) { return cv::Mat_<float>(height, width, 1.f); }
Camera camera(int width = 4, int height = 3) { return {width, height, 2, 4, 1.5, 1}; }

TEST(Frame, ProjectsPixelsThroughThePinhole) {
  const Frame frame = make_frame("f", {}, metre() * 2, camera());
  const Eigen::Vector3f p = frame.point(2 * 4 + 3);  // u = 3, v = 2
  EXPECT_FLOAT_EQ(p.x(), (3 - 1.5f) / 2 * 2);
  EXPECT_FLOAT_EQ(p.y(), (2 - 1.f) / 4 * 2);
  EXPECT_FLOAT_EQ(p.z(), 2);
}

TEST(Frame, TakesNothingThatIsNoDistanceForDepth) {
  cv::Mat_<float> depth = metre();
  depth(0, 0) = std::nanf("");
  depth(0, 1) = -1;
  depth(0, 2) = std::numeric_limits<float>::infinity();
  depth(1, 0) = 1e-40F;
  depth(1, 1) = 1e30F;
  depth(1, 2) = 1000.1F;
  const Frame frame = make_frame("f", {}, depth, camera());
  for (const int pixel : {0, 1, 2, 4, 5, 6}) {
    EXPECT_FALSE(frame.valid(pixel));
    EXPECT_EQ(frame.point(pixel), Eigen::Vector3f::Zero());
  }
  EXPECT_TRUE(frame.valid(3));
  EXPECT_TRUE(std::isnan(depth(0, 0))) << "the caller's image stays as it is";
}

TEST(Frame, RefusesWhatDoesNotFit) {
  EXPECT_THROW(make_frame("f", {}, {}, camera()), InputError);
  EXPECT_THROW(make_frame("f", {}, metre() * 0, camera()), InputError);
  EXPECT_THROW(make_frame("f", {}, metre(), camera(5)), InputError);
  EXPECT_THROW(make_frame("f", cv::Mat(3, 5, CV_8UC3), metre(), camera()), InputError);
  EXPECT_THROW(make_frame("f", cv::Mat(3, 4, CV_8UC1), metre(), camera()), InputError);
  for (const double wrong : {0.0, -1.0, std::nan(""), HUGE_VAL, 1e-30, 1e30}) {
    Camera c = camera();
    c.fx = wrong;
    EXPECT_THROW(make_frame("f", {}, metre(), c), InputError) << wrong;
  }
  Camera outside = camera();
  outside.cx = 7;
  EXPECT_THROW(make_frame("f", {}, metre(), outside), InputError);
}

TEST(Scene, SharesTheImagesThatItDerives) {
  const auto known = test::ridge(true);
  const Scene scene(known.frame, known.patches, known.surfaces);
  EXPECT_EQ(scene.grey().data, scene.grey().data);
  EXPECT_EQ(scene.yuv().data, scene.yuv().data);
  EXPECT_EQ(scene.grey().type(), CV_8UC1);
  EXPECT_EQ(scene.yuv().type(), CV_8UC3);
}

TEST(Scene, WithoutColourSaysSo) {
  auto known = test::ridge(true);
  known.frame.colour.release();
  const Scene scene(known.frame, known.patches, known.surfaces);
  EXPECT_THROW(scene.grey(), InputError);
  EXPECT_THROW(scene.yuv(), InputError);
}

}  // namespace
}  // namespace gestalt
