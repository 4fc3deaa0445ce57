// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <random>

#include "gestalt/tests/scenes/test_scenes.h"
#include "neighbour_moments.h"
#include "normal_estimation.h"
#include "patch_growing.h"
#include "patch_refinement.h"

namespace gestalt {
namespace {

Tolerances for_kinect(int width, int height, DepthNoise noise = {}) {
  Frame frame;
  frame.camera = test::kinect(width, height);
  frame.noise = noise;
  return {frame, {}};
}

TEST(Tolerances, OfAKinectAreThoseOfTheReference) {
  const Tolerances tolerances = for_kinect(640, 480);
  for (const float z : {0.7f, 0.9f, 1.1f, 1.3f}) {
    EXPECT_NEAR(tolerances.distance(z), -0.002 + 0.015 * z, 0.0015) << z;
    EXPECT_NEAR(std::acos(tolerances.cosine(z)), 0.58 + 0.1 * z, 0.04) << z;
    EXPECT_NEAR(std::sqrt(tolerances.squared_reach(z)), 0.005125 * z, 1e-5 * z) << z;
  }
  EXPECT_EQ(tolerances.window_radius(1), 3);
  EXPECT_EQ(tolerances.window_radius(3), 5);
  EXPECT_EQ(tolerances.window_radius(5), 9);
  EXPECT_EQ(tolerances.spur_radius(), 2);
  EXPECT_EQ(tolerances.min_patch_size(), 9);
  EXPECT_EQ(tolerances.smallest_island(), 30);
}

TEST(Tolerances, FollowTheResolution) {
  const Tolerances half = for_kinect(320, 240), twice = for_kinect(1280, 960);
  EXPECT_EQ(half.window_radius(1), 2);
  EXPECT_EQ(twice.window_radius(1), 6);
  EXPECT_EQ(half.spur_radius(), 1);
  EXPECT_EQ(twice.spur_radius(), 4);
  EXPECT_EQ(twice.min_patch_size(), 36);
  EXPECT_EQ(twice.smallest_island(), 120);
  EXPECT_EQ(half.window_step(), 1);
  EXPECT_EQ(for_kinect(640, 480).window_step(), 1);
  EXPECT_EQ(twice.window_step(), 2);
  EXPECT_EQ(for_kinect(2560, 1920).window_step(), 4);
  EXPECT_FLOAT_EQ(half.distance(1), twice.distance(1));
  EXPECT_FLOAT_EQ(half.squared_reach(1), 16 * twice.squared_reach(1));
}

TEST(Tolerances, FollowTheNoise) {
  const Tolerances quiet = for_kinect(640, 480, {0.0005, 0, 0}), loud = for_kinect(640, 480, {0.02, 0, 0});
  EXPECT_FLOAT_EQ(loud.distance(2), 40 * quiet.distance(2));
  EXPECT_GT(loud.window_radius(2), quiet.window_radius(2));
  // A window that grows with the noise keeps the normals as good as they are.
  EXPECT_LT(loud.cosine(2), quiet.cosine(2));
  EXPECT_NEAR(std::acos(loud.cosine(2)), 0.485 + 0.59 / 2, 0.03);
  EXPECT_LE(for_kinect(640, 480, {1, 0, 0}).window_radius(1), 64);
}

TEST(NormalEstimation, OfAPlaneAreItsNormal) {
  const auto scene = test::ridge(true);
  const NormalMap map = estimate_normals(scene.frame, Tolerances(scene.frame, {}));
  const cv::Vec3f left = map.normals(240, 270), right = map.normals(240, 370);
  EXPECT_NEAR(left[0], -std::sqrt(0.5f), 2e-3);
  EXPECT_NEAR(right[0], std::sqrt(0.5f), 2e-3);
  EXPECT_NEAR(left[2], -std::sqrt(0.5f), 2e-3);
  EXPECT_LT(map.curvature(240, 270), 1e-4f);
  EXPECT_GT(map.curvature(240, 320), 1e-2f);
  EXPECT_EQ(map.curvature(0, 0), 1.f);
}

// What lanes sum together is what each pixel sums alone, to the last bit.
TEST(NeighbourMoments, OfLanesAreThoseOfEachPixel) {
  std::mt19937 random(7);
  const auto uniform = [&] { return float(random()) / float(std::mt19937::max()); };
  cv::Mat_<cv::Vec3f> points(40, 60, cv::Vec3f());
  for (int v = 0; v < points.rows; ++v)
    for (int u = 0; u < points.cols; ++u) {
      const float z = (u < 30 ? 1.f : 1.3f) + 0.01f * uniform();
      if (uniform() < 0.9f) points(v, u) = {(float(u) - 30) * z / 525, (float(v) - 20) * z / 525, z};
    }
  const VectorPlanes planes(points);
  for (const NeighbourWindow& window : {NeighbourWindow{-3, 3, -3, 3, 1}, NeighbourWindow{-9, 9, -8, 6, 2}})
    for (int v = 10; v < 30; ++v)
      for (int u = 10; u < 40; u += 3) {
        WideFloats reach{};
        for (int i = 0; i < wide_lanes; ++i) reach[i] = 1e-5f * (1 + uniform());
        NeighbourMoments<WideFloats> together;
        sum_neighbours(planes, u, v, window, reach, together);
        for (int i = 0; i < wide_lanes; ++i) {
          NeighbourMoments<float> alone;
          sum_neighbours(planes, u + i, v, window, reach[i], alone);
          const auto values = [i](const auto& m, auto at) {
            return std::array{at(m.n, i),  at(m.x, i),  at(m.y, i),  at(m.w, i),  at(m.xx, i),
                              at(m.xy, i), at(m.xw, i), at(m.yy, i), at(m.yw, i), at(m.ww, i)};
          };
          EXPECT_EQ(values(together, [](const WideFloats& m, int k) -> float { return m[k]; }),
                    values(alone, [](float m, int) { return m; }));
        }
      }
}

TEST(NormalEstimation, DoNotCrossADepthJump) {
  const auto scene = test::rectangle_before_wall();
  const NormalMap map = estimate_normals(scene.frame, Tolerances(scene.frame, {}));
  for (const int u : {257, 258, 259, 260, 261, 262}) EXPECT_LT(map.normals(240, u)[2], -0.999f) << u;
}

}  // namespace
}  // namespace gestalt
