// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/evaluation/calibration/noise_calibration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

/// Depth of a plane through (0, 0, z0) with that slope in x and 0.3 of it in y; then changed by the sensor.
Frame tilted_wall(double z0, double slope, const std::function<double(double)>& sensor) {
  const Camera camera = test::kinect();
  cv::Mat_<float> depth(camera.height, camera.width);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u)
      depth(v, u) = float(sensor(z0 / (1 - slope * ((u - camera.cx) / camera.fx + 0.3 * (v - camera.cy) / camera.fy))));
  return make_frame("wall", {}, depth, camera);
}

void expect_noise(const NoiseEstimate& estimate, const DepthNoise& truth, double tolerance) {
  ASSERT_FALSE(estimate.bins.empty());
  for (const NoiseBin& bin : estimate.bins) {
    EXPECT_NEAR(bin.sigma, truth.at(bin.depth), tolerance * truth.at(bin.depth)) << bin.depth;
    EXPECT_NEAR(estimate.noise.at(bin.depth), truth.at(bin.depth), tolerance * truth.at(bin.depth)) << bin.depth;
  }
}

TEST(NoiseCalibration, FindsTheNoiseThatWasAdded) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  for (const DepthNoise& truth : {DepthNoise{0.002, 0, 0}, DepthNoise{0.001, 0.002, 0}, DepthNoise{0.0005, 0, 0.003}}) {
    NoiseCalibration calibration;
    for (const double z0 : {0.7, 1.2, 2.0, 3.0})
      calibration.add(tilted_wall(z0, 0.5, [&](double z) { return z + truth.at(z) * normal(random); }));
    const NoiseEstimate estimate = calibration.estimate();
    expect_noise(estimate, truth, 0.06);
    EXPECT_GT(estimate.bins.size(), 8u);
    EXPECT_NEAR(estimate.noise.at(6), truth.at(6), 0.3 * truth.at(6));  // beyond what was seen
  }
}

TEST(NoiseCalibration, OfAnExactPlaneIsTheLeastThereIs) {
  NoiseCalibration calibration;
  calibration.add(tilted_wall(1, 0.3, [](double z) { return z; }));
  const NoiseEstimate estimate = calibration.estimate();
  for (const NoiseBin& bin : estimate.bins) EXPECT_LT(bin.sigma, 3e-5);  // a step of 0.1 mm
  EXPECT_EQ(estimate.noise.at(1), 1e-4);
}

TEST(NoiseCalibration, CountsStepsOfTheReadingsWhereAWallFallsOnOne) {
  // Seen from the front all readings are one: what they tell is the step only where others show it.
  const double step = 0.01;
  NoiseCalibration calibration;
  for (const double z0 : {1.6, 1.61, 1.62, 1.63})
    calibration.add(tilted_wall(z0, 0, [&](double z) { return step * std::round(z / step); }));
  const NoiseEstimate estimate = calibration.estimate();
  ASSERT_FALSE(estimate.bins.empty());
  EXPECT_NEAR(estimate.bins.front().step, step, 1e-5);
  EXPECT_NEAR(estimate.noise.at(1.6), step / std::sqrt(12), 1e-5);
}

TEST(NoiseCalibration, IsNotFooledByEdgesAndClutter) {
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  const DepthNoise truth{0.001, 0, 0.002};
  NoiseCalibration calibration;
  for (const double z0 : {0.8, 1.1, 1.5}) {
    Frame frame = tilted_wall(z0, 0.4, [&](double z) { return z + truth.at(z) * normal(random); });
    // Posts on nearly half of the windows, and some pixels without depth.
    for (int v = 0; v < frame.height() / 2; ++v)
      for (int u = 0; u < frame.width(); ++u) {
        if (u % 20 < 4) frame.depth(v, u) -= 0.05f;
        if (u % 13 == v % 11) frame.depth(v, u) = 0;
      }
    calibration.add(frame);
  }
  expect_noise(calibration.estimate(), truth, 0.1);
}

TEST(NoiseCalibration, RefusesFramesWithoutSurfaces) {
  cv::Mat_<float> depth(480, 640, 0.f);
  depth(100, 100) = 1;
  NoiseCalibration calibration;
  EXPECT_THROW(calibration.estimate(), InputError);
  calibration.add(make_frame("speck", {}, depth, test::kinect()));
  EXPECT_THROW(calibration.estimate(), InputError);
}

TEST(NoiseCalibration, TakesImagesSmallerThanAWindow) {
  const Camera tiny{3, 2, 525, 525, 1, 1};
  NoiseCalibration calibration;
  calibration.add(make_frame("tiny", {}, cv::Mat_<float>(2, 3, 1.f), tiny));
  EXPECT_THROW(calibration.estimate(), InputError);
}

}  // namespace
}  // namespace gestalt
