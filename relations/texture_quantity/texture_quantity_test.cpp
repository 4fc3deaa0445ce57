// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "texture_quantity.h"

#include <gtest/gtest.h>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f before{0, 0, 1}, facing{0, 0, -1};

double r_tr(const test::KnownScene& known, int a, int b, const TextureQuantity::Params& params = {}) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*TextureQuantity(params).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

/// Two plain patches, 60 x 60 px each and far from each other, in an image of one grey.
test::KnownScene plain() {
  auto scene = test::render({{{100, 100, 60, 60}, before, facing}, {{300, 100, 60, 60}, before, facing}});
  scene.frame.colour.setTo(cv::Scalar::all(100));
  return scene;
}

TEST(TextureQuantity, IsZeroForPlainPatches) { EXPECT_EQ(r_tr(plain(), 0, 1), 0); }

TEST(TextureQuantity, IsTheShareOfEdgePixels) {
  auto scene = plain();
  // One step across all of surface 0: an edge one pixel wide on each of its 60 rows.
  scene.frame.colour(cv::Rect(130, 60, 100, 140)).setTo(cv::Scalar::all(250));
  EXPECT_DOUBLE_EQ(r_tr(scene, 0, 1), 60.0 / 3600.0);
  EXPECT_DOUBLE_EQ(r_tr(scene, 1, 0), 60.0 / 3600.0);
}

TEST(TextureQuantity, IsZeroForEquallyTexturedPatches) {
  auto scene = plain();
  scene.frame.colour(cv::Rect(130, 60, 100, 140)).setTo(cv::Scalar::all(250));
  scene.frame.colour(cv::Rect(330, 60, 100, 140)).setTo(cv::Scalar::all(250));
  EXPECT_EQ(r_tr(scene, 0, 1), 0);
}

TEST(TextureQuantity, IgnoresStepsBelowTheHighThreshold) {
  auto scene = plain();
  // Blurred over 3 px, a step of 30 has a Sobel gradient of 4 * 20 = 80 at most.
  scene.frame.colour(cv::Rect(130, 60, 100, 140)).setTo(cv::Scalar::all(130));
  EXPECT_EQ(r_tr(scene, 0, 1), 0);
  EXPECT_DOUBLE_EQ(r_tr(scene, 0, 1, {.high_threshold = 70}), 60.0 / 3600.0);
}

TEST(TextureQuantity, OfASinglePixelIsZeroOrOne) {
  auto scene = test::render({{{129, 100, 1, 1}, before, facing}, {{300, 100, 1, 1}, before, facing}});
  scene.frame.colour.setTo(cv::Scalar::all(100));
  EXPECT_EQ(r_tr(scene, 0, 1), 0);
  scene.frame.colour(cv::Rect(130, 60, 100, 140)).setTo(cv::Scalar::all(250));
  EXPECT_EQ(r_tr(scene, 0, 1), 1);
}

TEST(TextureQuantity, WorksOnAnImageOfOnePixel) {
  const auto scene = test::render({{{0, 0, 1, 1}, before, facing}}, {1, 1, 1, 1, 0, 0});
  EXPECT_EQ(r_tr(scene, 0, 0), 0);
}

}  // namespace
}  // namespace gestalt
