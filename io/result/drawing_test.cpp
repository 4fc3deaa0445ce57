// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "gestalt/io/result/result.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

TEST(DrawNormals, GivesEachDirectionItsColour) {
  cv::Mat_<cv::Vec3f> normals(1, 4, cv::Vec3f());
  normals(0, 1) = {0, 0, -1};
  normals(0, 2) = {1, 0, 0};
  normals(0, 3) = {0, -1, 0};
  const cv::Mat picture = draw_normals(normals);
  ASSERT_EQ(picture.type(), CV_8UC3);
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 0), cv::Vec3b(0, 0, 0));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 1), cv::Vec3b(255, 128, 128));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 2), cv::Vec3b(0, 128, 255));
  EXPECT_EQ(picture.at<cv::Vec3b>(0, 3), cv::Vec3b(0, 0, 128));
}

TEST(SurfaceNormals, AreThoseOfTheModels) {
  const test::KnownScene scene = test::ridge(true);
  const cv::Mat_<cv::Vec3f> normals = surface_normals(scene.frame, scene.surfaces);
  for (int i = 0; i < int(scene.surfaces.labels.total()); ++i) {
    const int label = scene.surfaces.labels.ptr<int>()[i];
    const cv::Vec3f normal = normals.ptr<cv::Vec3f>()[i];
    if (label == 0) {
      EXPECT_EQ(normal, cv::Vec3f());
      continue;
    }
    // Faces at 45 degrees to the view, the left one turned to the left.
    EXPECT_NEAR(normal[0], label == 1 ? -std::sqrt(0.5) : std::sqrt(0.5), 1e-5);
    EXPECT_NEAR(normal[2], -std::sqrt(0.5), 1e-5);
  }
}

/// Three squares side by side, whose nodes are at columns 20, 60 and 100 of row 20, at twice that in the picture.
class DrawGraph : public testing::Test {
 protected:
  cv::Vec3b halfway(int a, int b, double probability, Level level) const {
    const cv::Mat picture =
        draw_graph(scene_.frame, scene_.surfaces, {{1600, 1600, 1600}, {{a, b, probability, level}}});
    EXPECT_EQ(picture.size(), cv::Size(2 * scene_.frame.width(), 2 * scene_.frame.height()));
    return picture.at<cv::Vec3b>(40, 80);  // between the first two
  }

  static test::PlanarPatch square(int left) { return {{left, 0, 40, 40}, {0, 0, 1}, {0, 0, -1}}; }
  const test::KnownScene scene_ = test::render({square(0), square(40), square(80)});
  const cv::Vec3b dimmed_{58, 58, 58};  // 0.45 of the squares' grey
};

TEST_F(DrawGraph, ColoursAnEdgeByItsProbability) {
  EXPECT_EQ(halfway(0, 1, 0, Level::structural), cv::Vec3b(0, 0, 255));
  EXPECT_EQ(halfway(0, 1, 0.5, Level::structural), cv::Vec3b(0, 255, 255));
  EXPECT_EQ(halfway(0, 1, 1, Level::structural), cv::Vec3b(0, 255, 0));
  EXPECT_EQ(halfway(0, 2, 1, Level::assembly)[1], 255);
}

TEST_F(DrawGraph, LeavesOutUnlikelyPairsOfTheAssemblyLevel) {
  EXPECT_EQ(halfway(1, 2, 1, Level::structural), dimmed_);
  EXPECT_EQ(halfway(0, 1, 0.49, Level::assembly), dimmed_);
  EXPECT_NE(halfway(0, 1, 0.51, Level::assembly), dimmed_);
}

}  // namespace
}  // namespace gestalt
