// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/noise_estimate.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const DepthNoise unit{0.0005, 0.001, 0};

/// A tilted wall with noise of this multiple of `unit`, and what else there is in front of it.
Frame noisy_wall(double multiple, const std::function<double(int, int)>& clutter = nullptr) {
  const Camera camera = test::kinect();
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  cv::Mat_<float> depth(camera.height, camera.width);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      double z = 1.2 / (1 - 0.4 * (u - camera.cx) / camera.fx);
      if (clutter) z += clutter(u, v);
      depth(v, u) = float(z + multiple * unit.at(z) * normal(random));
    }
  return make_frame("wall", {}, depth, camera);
}

TEST(NoiseEstimate, FindsTheNoiseThatWasAdded) {
  for (const double multiple : {0.5, 1.0, 3.0})
    EXPECT_NEAR(estimate_noise(noisy_wall(multiple), unit).value(), multiple, 0.1 * multiple) << multiple;
}

TEST(NoiseEstimate, LooksPastClutter) {
  // Blocks, 20 px wide, stand in two thirds of the image: nearly all windows there hold an edge.
  const auto blocks = [](int u, int) { return u < 430 && u / 20 % 2 ? -0.1 : 0.0; };
  EXPECT_NEAR(estimate_noise(noisy_wall(1, blocks), unit).value(), 1, 0.1);
}

TEST(NoiseEstimate, NeedsSmoothSurfaceEnough) {
  Frame frame = noisy_wall(1);
  frame.depth.colRange(100, frame.depth.cols).setTo(0);  // 3 windows wide, 14 high
  EXPECT_TRUE(estimate_noise(frame, unit));
  frame.depth.colRange(60, frame.depth.cols).setTo(0);
  EXPECT_FALSE(estimate_noise(frame, unit));
  frame.depth.setTo(0);
  EXPECT_FALSE(estimate_noise(frame, unit));
}

}  // namespace
}  // namespace gestalt
