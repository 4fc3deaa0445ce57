// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normals.h"

#include <gtest/gtest.h>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

int label_at(const PatchMap& map, int u, int v) { return map.labels(v, u); }

TEST(Normals, CutsARidgeInTwoPatches) {
  const PatchMap map = Normals({}).cluster(test::ridge(true).frame);
  EXPECT_EQ(map.count, 2);
  EXPECT_NE(label_at(map, 240, 240), label_at(map, 400, 240));
  EXPECT_EQ(label_at(map, 240, 150), label_at(map, 240, 330));
  EXPECT_EQ(label_at(map, 0, 0), 0);
}

TEST(Normals, CutsAStepInParallelPlanes) {
  const PatchMap map = Normals({}).cluster(test::rectangle_before_wall().frame);
  EXPECT_EQ(map.count, 2);
  EXPECT_NE(label_at(map, 320, 240), label_at(map, 120, 240));
  EXPECT_EQ(label_at(map, 520, 240), label_at(map, 120, 240));
}

TEST(Normals, LeavesASpeckInNoPatch) {
  const auto scene = test::render({{{300, 200, 1, 1}, {0, 0, 1}, {0, 0, -1}}});
  EXPECT_EQ(Normals({}).cluster(scene.frame).count, 0);
  Normals::Params all;
  all.smallest_island = 0;
  const PatchMap map = Normals(all).cluster(scene.frame);
  EXPECT_EQ(map.count, 1);
  EXPECT_EQ(label_at(map, 300, 200), 1);
  EXPECT_EQ(cv::countNonZero(map.labels), 1);
}

TEST(Normals, SinksASpeckIntoThePatchAroundIt) {
  const auto scene =
      test::render({{{100, 100, 60, 60}, {0, 0, 1}, {0, 0, -1}}, {{130, 130, 2, 2}, {0, 0, 0.97f}, {0, 0, -1}}});
  const PatchMap map = Normals({}).cluster(scene.frame);
  EXPECT_EQ(map.count, 1);
  EXPECT_EQ(label_at(map, 130, 130), 1);
}

TEST(Normals, LeavesNoPatchSmallerThanAnIslandWhereSpecksTouch) {
  // A noisy strip of small steps beside a plane: specks beside specks.
  std::vector<test::PlanarPatch> patches{{{100, 100, 60, 60}, {0, 0, 1}, {0, 0, -1}}};
  for (int i = 0; i < 12; ++i)
    patches.push_back({{120 + 2 * i, 120, 2, 2}, {0, 0, 1 - 0.015f * float(1 + i % 3)}, {0, 0, -1}});
  const PatchMap map = Normals({}).cluster(test::render(patches).frame);
  std::vector<int> sizes(std::size_t(map.count) + 1, 0);
  for (int p = 0; p < int(map.labels.total()); ++p) ++sizes[std::size_t(map.labels.ptr<int>()[p])];
  for (const int size : sizes) EXPECT_GE(size, 30);
}

TEST(Normals, LabelsEveryValidPixelAndLeavesNoGap) {
  const auto scene = test::rectangle_before_wall();
  const PatchMap map = Normals({}).cluster(scene.frame);
  std::vector<int> used(std::size_t(map.count) + 1, 0);
  for (int p = 0; p < int(map.labels.total()); ++p) {
    EXPECT_EQ(map.labels.ptr<int>()[p] > 0, scene.frame.valid(p));
    used[std::size_t(map.labels.ptr<int>()[p])] = 1;
  }
  for (const int u : used) EXPECT_EQ(u, 1);
}

TEST(Normals, CutsAlongColourEdgesOnlyWhereItIsAskedToAndThereIsColour) {
  auto scene = test::render({{{200, 150, 160, 160}, {0, 0, 1}, {0, 0, -1}, {40, 40, 200}}});
  scene.frame.colour(cv::Rect(200, 150, 60, 160)).setTo(cv::Scalar(200, 60, 40));
  EXPECT_EQ(Normals({}).cluster(scene.frame).count, 1);
  Normals::Params cutting;
  cutting.cut_share = 0.8;
  const PatchMap map = Normals(cutting).cluster(scene.frame);
  EXPECT_EQ(map.count, 2);
  EXPECT_EQ(map.cut_from, (std::vector<int>{1, 1}));
  scene.frame.colour = cv::Mat();
  EXPECT_EQ(Normals(cutting).cluster(scene.frame).count, 1);
}

}  // namespace
}  // namespace gestalt
