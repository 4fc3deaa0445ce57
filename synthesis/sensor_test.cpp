// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "active_stereo.h"
#include "ground_truth.h"
#include "kinect.h"
#include "render.h"
#include "sensor.h"
#include "shapes.h"
#include "time_of_flight.h"

namespace gestalt::synthesis {
namespace {

Body body_of(Mesh mesh, const Eigen::Isometry3d& pose = Eigen::Isometry3d::Identity()) {
  return {std::move(mesh), {{plain({150, 150, 150})}}, Eigen::Vector3d::Zero(), pose};
}

/// The camera at a height above the origin, looking straight down on a table of 4 x 4 m.
Arrangement seen_from_above(double height, std::vector<Body> things) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::AngleAxisd(CV_PI, Eigen::Vector3d::UnitX()).toRotationMatrix();
  pose.translation().z() = height;
  Eigen::Isometry3d below = Eigen::Isometry3d::Identity();
  below.translation().z() = -0.03;
  Lighting lighting{{0, 0, 2}, 0.1, {0, 0, 1}, 0.5, 0.2, 0.4, {1, 1, 1}};
  return {{kinect_camera(), pose}, lighting, body_of(box({4, 4, 0.03}), below), {}, {}, std::move(things)};
}

/// Mean and deviation of the measured depth of the table in metres, in the image's middle.
struct Spread {
  double mean, deviation;
};

Spread spread_at(double height) {
  Random random(3);
  const Measurement measurement =
      measure_structured_light(render(seen_from_above(height, {})), kinect_camera(), random);
  double sum = 0, squares = 0;
  int count = 0;
  for (int v = 100; v < 380; ++v)
    for (int u = 100; u < 540; ++u)
      if (const double z = measurement.depth(v, u) / 1000.0; z > 0) {
        sum += z;
        squares += (z - height) * (z - height);
        ++count;
      }
  return {sum / count, std::sqrt(squares / count)};
}

TEST(Render, DepthOfABoxIsItsDistance) {
  const IdealView view = render(seen_from_above(1.0, {body_of(box({0.2, 0.1, 0.25}))}));
  EXPECT_EQ(view.body(239, 319), 1);
  EXPECT_NEAR(view.depth(239, 319), 0.75, 1e-5);
  EXPECT_EQ(view.body(20, 20), IdealView::table);
  EXPECT_NEAR(view.depth(20, 20), 1.0, 1e-5);
  // The top reaches 0.1 m to each side: 525 * 0.1 / 0.75 = 70 pixels from 319.5.
  EXPECT_EQ(view.body(239, 319 - 69), 1);
  EXPECT_NE(view.body(239, 319 - 71), 1);
}

TEST(Render, DepthOfABallFollowsTheRay) {
  const double radius = 0.1;
  const Arrangement arrangement = seen_from_above(1.0, {body_of(superellipsoid({radius, radius, radius}, 1, 1))});
  const IdealView view = render(arrangement);
  const Camera camera = kinect_camera();
  for (const int u : {280, 300, 319, 350}) {
    // A ray (x, 0, 1) t meets the sphere around (0, 0, 0.9): t^2 (x^2 + 1) - 1.8 t + 0.81 - r^2 = 0.
    const double x = (u - camera.cx) / camera.fx, y = (239 - camera.cy) / camera.fy, a = x * x + y * y + 1;
    const double z = (0.9 - std::sqrt(0.81 - a * (0.81 - radius * radius))) / a;
    EXPECT_NEAR(view.depth(239, u), z, 5e-4) << u;
  }
}

TEST(Render, PixelBeyondTheTableHasNoDepth) {
  Arrangement arrangement = seen_from_above(1.0, {});
  arrangement.table.mesh = box({0.5, 0.5, 0.03});
  const IdealView view = render(arrangement);
  EXPECT_EQ(view.body(10, 10), IdealView::nothing);
  EXPECT_EQ(view.depth(10, 10), 0);
  Random random(1);
  EXPECT_EQ(measure_structured_light(view, kinect_camera(), random).depth(10, 10), 0);
}

TEST(Render, ProjectorShadowLiesOnTheLeft) {
  // The table beside the box's left side at height h is hidden from the projector up to
  // b h / (Z - h) = 0.05 * 0.3 / 0.7 = 21 mm = 11 px, from the infrared camera on the right up to half of it.
  const IdealView view = render(seen_from_above(1.0, {body_of(box({0.1, 0.1, 0.3}))}));
  int left = 0, right = 0;
  for (int u = 0; u < 640; ++u)
    if (view.body(239, u) == IdealView::table && !view.measurable(239, u)) ++(u < 320 ? left : right);
  // As seen by the colour camera the box's top already hides 0.05 * 0.3 / 0.7 m of the table on either side.
  EXPECT_NEAR(left, 525 * 0.05 * 0.3 / 0.7, 2);
  EXPECT_NEAR(right, 525 * 0.025 * 0.3 / 0.7, 2);

  Random random(1);
  const Measurement measurement = measure_structured_light(view, kinect_camera(), random);
  for (int v = 230; v < 250; ++v) {
    int lost = 0;
    for (int u = 220; u < 320; ++u) lost += measurement.depth(v, u) == 0;
    EXPECT_GE(lost, 6) << v;
  }
}

TEST(Kinect, StepIsThatOfAnEighthOfAPixel) {
  EXPECT_NEAR(depth_step(1), 2.87e-3, 1e-5);
  EXPECT_NEAR(depth_step(2) / depth_step(1), 4, 1e-12);
}

TEST(Kinect, MeasuredDepthsAreThoseOfQuantisedDisparities) {
  Random random(3);
  const Measurement measurement = measure_structured_light(render(seen_from_above(1.5, {})), kinect_camera(), random);
  std::set<int> depths(measurement.depth.begin(), measurement.depth.end());
  depths.erase(0);
  EXPECT_GE(depths.size(), 3u);
  for (const int millimetres : depths) {
    const double eighths = 8 * 580 * 0.075 / (millimetres / 1000.0);
    EXPECT_NEAR(eighths, std::round(eighths), 0.08);  // half a millimetre is 0.077 of a step here
  }
}

TEST(Kinect, NoiseHasNoBiasAndGrowsWithTheSquareOfDepth) {
  const Spread near = spread_at(0.7), far = spread_at(1.4);
  EXPECT_NEAR(near.mean, 0.7, 2e-4);
  EXPECT_NEAR(far.mean, 1.4, 1e-3);
  // Half a step of noise and the quantisation's step / sqrt(12).
  const double expected = std::sqrt(0.25 + 1.0 / 12);
  EXPECT_NEAR(near.deviation / depth_step(0.7), expected, 0.08);
  EXPECT_NEAR(far.deviation / depth_step(1.4), expected, 0.08);
}

TEST(Kinect, LosesSurfacesAtGrazingAngles) {
  IdealView view = render(seen_from_above(1.0, {}));
  view.slant = 0.03f;  // 88 degrees
  Random random(1);
  EXPECT_EQ(cv::countNonZero(measure_structured_light(view, kinect_camera(), random).depth), 0);
}

/// Mean of the measured depths (metres) in a row's pixels [left, right) over several runs; 0 are left out.
double mean_depth(SensorModel sensor, const IdealView& view, int left, int right) {
  double sum = 0;
  int count = 0;
  for (int seed = 0; seed < 6; ++seed) {
    Random random{std::uint64_t(seed)};
    const Measurement measurement = measure_depth(sensor, view, kinect_camera(), random);
    for (int v = 180; v < 300; ++v)
      for (int u = left; u < right; ++u)
        if (const int millimetres = measurement.depth(v, u)) {
          sum += millimetres / 1000.0;
          ++count;
        }
  }
  return sum / count;
}

/// Two boards of 0.6 m that meet at a right angle, below the camera's middle column, as a gutter seen from above.
Arrangement gutter_from_above(double height) {
  Body board = body_of(box({0.6, 2, 0.01}));
  std::vector<Body> boards;
  for (const double side : {-1.0, 1.0}) {
    board.pose =
        Eigen::AngleAxisd(-side * CV_PI / 4, Eigen::Vector3d::UnitY()) * Eigen::Translation3d(side * 0.3, 0, -0.01);
    boards.push_back(board);
  }
  Arrangement arrangement = seen_from_above(height, boards);
  arrangement.table.pose.translation().z() = -0.5;
  return arrangement;
}

TEST(ActiveStereo, NoiseGrowsWithTheSquareOfDepth) {
  EXPECT_NEAR(stereo_deviation(1, 0.08), 0.0025, 1e-9);
  EXPECT_NEAR(stereo_deviation(2, 0.1) / stereo_deviation(1, 0.1), 4, 1e-12);
  const IdealView view = render(seen_from_above(1.0, {}), SensorModel::active_stereo);
  Random random(3);
  const Measurement measurement = measure_active_stereo(view, kinect_camera(), random);
  double sum = 0, squares = 0, neighbours = 0;
  int count = 0;
  for (int v = 100; v < 380; ++v)
    for (int u = 150; u < 540; ++u) {
      if (!measurement.depth(v, u) || !measurement.depth(v, u + 3)) continue;
      const double error = measurement.depth(v, u) / 1000.0 - 1, beside = measurement.depth(v, u + 3) / 1000.0 - 1;
      sum += error;
      squares += error * error;
      neighbours += error * beside;
      ++count;
    }
  const double deviation = std::sqrt(squares / count);
  EXPECT_NEAR(sum / count, 0, 5e-4);
  EXPECT_GT(deviation, stereo_deviation(1, 0.02));
  EXPECT_LT(deviation, stereo_deviation(1, 0.13));
  EXPECT_GT(neighbours / squares, 0.3);  // bumps, not grain
}

TEST(ActiveStereo, RoundsACrease) {
  const IdealView view = render(gutter_from_above(0.9), SensorModel::active_stereo);
  const double crease = mean_depth(SensorModel::active_stereo, view, 318, 322);
  const double beside = mean_depth(SensorModel::active_stereo, view, 358, 362);
  EXPECT_LT(crease, double(view.depth(239, 319)) - 0.001);
  EXPECT_NEAR(beside, double(view.depth(239, 360)), 0.001);
}

TEST(ActiveStereo, ShadowLiesOnTheLeftAlone) {
  const IdealView view = render(seen_from_above(1.0, {body_of(box({0.1, 0.1, 0.3}))}), SensorModel::active_stereo);
  int left = 0, right = 0;
  for (int u = 0; u < 640; ++u)
    if (view.body(239, u) == IdealView::table && !view.measurable(239, u)) ++(u < 320 ? left : right);
  EXPECT_NEAR(left, 525 * right_imager_x * 0.3 / 0.7, 2);
  EXPECT_EQ(right, 0);
}

TEST(ActiveStereo, NearSurfacesGrow) {
  const IdealView view = render(seen_from_above(1.0, {body_of(box({0.2, 0.2, 0.3}))}), SensorModel::active_stereo);
  const int truth = cv::countNonZero(view.body == 1);
  int measured = 0;
  for (int seed = 0; seed < 4; ++seed) {
    Random random{std::uint64_t(seed)};
    measured += cv::countNonZero(measure_active_stereo(view, kinect_camera(), random).body == 1);
  }
  EXPECT_GT(measured / 4, truth);
}

TEST(TimeOfFlight, PixelsFlyBetweenSurfaces) {
  const IdealView view = render(seen_from_above(1.0, {body_of(box({0.2, 0.2, 0.3}))}), SensorModel::time_of_flight);
  int flying = 0;
  for (int seed = 0; seed < 4; ++seed) {
    Random random{std::uint64_t(seed)};
    for (const int millimetres : measure_time_of_flight(view, kinect_camera(), random).depth)
      flying += millimetres > 750 && millimetres < 950;
  }
  EXPECT_GT(flying, 200);
  for (const float depth : view.depth) ASSERT_FALSE(depth > 0.75f && depth < 0.95f);
}

TEST(TimeOfFlight, NoiseIsThatOfTheModel) {
  EXPECT_NEAR(time_of_flight_deviation(1), 0.0015, 1e-12);
  const IdealView view = render(seen_from_above(1.0, {}), SensorModel::time_of_flight);
  EXPECT_NEAR(mean_depth(SensorModel::time_of_flight, view, 280, 360), 1.0, 5e-4);
}

TEST(TimeOfFlight, MultipathLeavesTheCreaseAndPushesItsSidesBack) {
  const IdealView view = render(gutter_from_above(0.9), SensorModel::time_of_flight);
  const cv::Mat_<float> bias = multipath(view, kinect_camera());
  EXPECT_GT(bias(239, 380), 0.001f);
  EXPECT_GT(bias(239, 380), bias(239, 319));
  const IdealView flat = render(seen_from_above(1.0, {}), SensorModel::time_of_flight);
  EXPECT_NEAR(multipath(flat, kinect_camera())(239, 319), 0, 1e-5);
}

TEST(TimeOfFlight, DarkSurfacesDropOut) {
  IdealView view = render(seen_from_above(1.5, {}), SensorModel::time_of_flight);
  view.colour = cv::Vec3f(2, 2, 2);
  Random random(1);
  EXPECT_LT(cv::countNonZero(measure_time_of_flight(view, kinect_camera(), random).depth), 640 * 480 / 10);
}

TEST(GroundTruth, FurnitureIsBackground) {
  cv::Mat_<std::uint16_t> depth(20, 20, std::uint16_t(1000));
  cv::Mat_<int> body(20, 20, 0);
  body(cv::Rect(0, 0, 6, 6)) = IdealView::first_furniture;
  body(cv::Rect(10, 0, 6, 6)) = IdealView::first_furniture - 3;
  body(cv::Rect(5, 12, 6, 6)) = 1;
  const auto labels = label_parts(depth, body);
  EXPECT_EQ(labels(19, 19), 1);
  EXPECT_EQ(labels(0, 0), 2);
  EXPECT_EQ(labels(0, 12), 3);
  EXPECT_EQ(labels(14, 7), 20);
}

TEST(GroundTruth, NumbersPartsBySize) {
  // Thing 1 is cut into 25 and 24 pixels, thing 2 is whole but for a pixel without depth; the rest is table.
  cv::Mat_<std::uint16_t> depth(20, 20, std::uint16_t(1000));
  cv::Mat_<int> body(20, 20, 0);
  body(cv::Rect(0, 0, 6, 4)) = 1;
  body(cv::Rect(10, 0, 5, 5)) = 1;
  body(cv::Rect(5, 10, 6, 6)) = 2;
  depth(12, 7) = 0;
  const auto labels = label_parts(depth, body);
  EXPECT_EQ(labels(0, 0), 21);
  EXPECT_EQ(labels(0, 12), 20);
  EXPECT_EQ(labels(10, 5), 30);
  EXPECT_EQ(labels(12, 7), 0);
  EXPECT_EQ(labels(19, 19), 1);
}

TEST(GroundTruth, TearsPartsAtDepthJumpsAndKeepsSpecksWithTheLargest) {
  cv::Mat_<std::uint16_t> depth(10, 20, std::uint16_t(1000));
  depth(cv::Rect(12, 0, 8, 10)) = 1100;
  depth(5, 5) = 1500;
  const auto labels = label_parts(depth, cv::Mat_<int>(10, 20, 1));
  EXPECT_EQ(labels(0, 0), 20);
  EXPECT_EQ(labels(0, 19), 21);
  EXPECT_EQ(labels(5, 5), 20);
}

TEST(GroundTruth, OfNothingIsNothing) {
  EXPECT_EQ(cv::countNonZero(label_parts(cv::Mat_<std::uint16_t>(1, 1, std::uint16_t(0)), cv::Mat_<int>(1, 1, -1))), 0);
}

}  // namespace
}  // namespace gestalt::synthesis
