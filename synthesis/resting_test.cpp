// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>

#include "height_field.h"
#include "mesh.h"
#include "random.h"
#include "shapes.h"

namespace gestalt::synthesis {
namespace {

std::vector<Eigen::Vector3f> moved(std::vector<Eigen::Vector3f> points, const Eigen::Vector3f& by) {
  for (Eigen::Vector3f& point : points) point += by;
  return points;
}

TEST(HeightField, ThingRestsOnTheTableAndOnWhatLiesThere) {
  const auto points = sample_surface(box({0.1, 0.1, 0.05}), 0.0025);
  HeightField field;
  EXPECT_NEAR(field.resting_height(points, Eigen::Matrix3d::Identity(), 0, 0), 0, 1e-6);
  field.add(points);
  EXPECT_NEAR(field.resting_height(points, Eigen::Matrix3d::Identity(), 0.05, 0), 0.05, 1e-6);
  EXPECT_NEAR(field.resting_height(points, Eigen::Matrix3d::Identity(), 0.11, 0), 0, 1e-6);
}

TEST(HeightField, BowlHoldsWhatFallsIntoIt) {
  HeightField field;
  field.add(sample_surface(bowl(0.1, 0.05, 0.08, 0.005), 0.0025));
  const auto ball = sample_surface(superellipsoid({0.02, 0.02, 0.02}, 1, 1), 0.0025);
  const double height = field.resting_height(ball, Eigen::Matrix3d::Identity(), 0, 0);
  EXPECT_GT(height, 0.004);
  EXPECT_LT(height, 0.02);
}

TEST(Settle, UprightBoxStays) {
  const auto points = sample_surface(box({0.1, 0.04, 0.25}), 0.005);
  const auto pose = settle({}, points, {0, 0, 0.125}, Eigen::Matrix3d::Identity(), 0.1, 0.2, 4);
  EXPECT_TRUE(pose.linear().isApprox(Eigen::Matrix3d::Identity(), 1e-9));
  EXPECT_TRUE(pose.translation().isApprox(Eigen::Vector3d(0.1, 0.2, 0), 1e-6));
}

TEST(Settle, TiltedBoxFallsOntoAFace) {
  const auto points = sample_surface(box({0.2, 0.15, 0.06}), 0.005);
  const Eigen::Vector3d centre(0, 0, 0.03);
  const Eigen::Matrix3d tilted = Eigen::AngleAxisd(0.5, Eigen::Vector3d::UnitY()).toRotationMatrix();
  const auto pose = settle({}, points, centre, tilted, 0, 0, 15);
  EXPECT_GT(pose.linear()(2, 2), std::cos(0.03));
  EXPECT_NEAR((pose * centre).z(), 0.03, 0.004);
}

TEST(Settle, BoxOnACornerFallsOntoAFace) {
  const auto points = sample_surface(box({0.2, 0.15, 0.06}), 0.005);
  const Eigen::Vector3d centre(0, 0, 0.03);
  const Eigen::Matrix3d on_corner =
      Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 0.8, 0.3).normalized()).toRotationMatrix();
  const auto pose = settle({}, points, centre, on_corner, 0, 0, 15);
  EXPECT_NEAR(pose.linear().row(2).cwiseAbs().maxCoeff(), 1, 0.01);
}

TEST(Settle, BoxOverAnEdgeLeansOnIt) {
  HeightField field;
  field.add(moved(sample_surface(box({0.1, 0.3, 0.05}), 0.0025), {-0.05f, 0, 0}));
  const auto points = sample_surface(box({0.2, 0.1, 0.04}), 0.004);
  // Its centre is 3 cm beyond the edge at x = 0: it tips over it until its end meets the table.
  const auto pose = settle(field, points, {0, 0, 0.02}, Eigen::Matrix3d::Identity(), 0.03, 0, 4);
  EXPECT_GT(pose.linear()(2, 0), -0.8);
  EXPECT_LT(pose.linear()(2, 0), -0.2);
}

TEST(Random, IsUniformAndNormal) {
  Random random(42);
  double sum = 0, squares = 0, normals = 0, normal_squares = 0;
  constexpr int count = 100000;
  for (int i = 0; i < count; ++i) {
    const double u = random.uniform(), n = double(random.normal());
    ASSERT_GE(u, 0);
    ASSERT_LT(u, 1);
    sum += u;
    squares += u * u;
    normals += n;
    normal_squares += n * n;
  }
  EXPECT_NEAR(sum / count, 0.5, 0.005);
  EXPECT_NEAR(squares / count, 1.0 / 3, 0.005);
  EXPECT_NEAR(normals / count, 0, 0.015);
  EXPECT_NEAR(normal_squares / count, 1, 0.02);
}

TEST(Random, FirstNumberOfSplitmixIsThePublishedOne) { EXPECT_EQ(Random(0).bits(), 0xe220a8397b1dcdafu); }

TEST(Random, StreamsDiffer) { EXPECT_NE(Random::of(1, 0).bits(), Random::of(1, 1).bits()); }

}  // namespace
}  // namespace gestalt::synthesis
