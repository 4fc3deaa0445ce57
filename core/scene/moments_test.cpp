// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/moments.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace gestalt {
namespace {

/// The corners of a rectangle of 0.2 x 0.4 m at z = 1.
const std::vector<Eigen::Vector3f> rectangle{{-0.1f, -0.2f, 1}, {0.1f, -0.2f, 1}, {-0.1f, 0.2f, 1}, {0.1f, 0.2f, 1}};

TEST(Moments, AreThoseOfTheirPoints) {
  const Moments moments(rectangle);
  EXPECT_EQ(moments.weight, 4);
  EXPECT_TRUE(moments.mean().isApprox(Eigen::Vector3d(0, 0, 1), 1e-6));
  EXPECT_TRUE(moments.covariance().isApprox(Eigen::Vector3d(0.01, 0.04, 0).asDiagonal().toDenseMatrix(), 1e-6));
}

TEST(Moments, OfTwoSetsAddUp) {
  const std::span<const Eigen::Vector3f> points(rectangle);
  const Moments sum = Moments(points.first(1)) + Moments(points.subspan(1)), all(points);
  EXPECT_EQ(sum.weight, all.weight);
  EXPECT_TRUE(sum.sum.isApprox(all.sum));
  EXPECT_TRUE(sum.squares.isApprox(all.squares));
}

TEST(Moments, CountAPointByItsWeight) {
  Moments once, twice;
  once.add({1, 2, 3}, 2);
  twice.add({1, 2, 3});
  twice.add({1, 2, 3});
  EXPECT_EQ(once.weight, twice.weight);
  EXPECT_EQ(once.sum, twice.sum);
  EXPECT_EQ(once.squares, twice.squares);
}

TEST(Moments, NormalPointsToTheCameraOnBothSides) {
  for (const float side : {1.f, -1.f}) {
    std::vector<Eigen::Vector3f> tilted;
    for (const Eigen::Vector3f& point : rectangle) tilted.push_back(side * (point + Eigen::Vector3f(0, 0, point.x())));
    const Moments moments(tilted);
    EXPECT_LT(moments.normal().dot(moments.mean()), 0);
    EXPECT_NEAR(std::abs(moments.normal().dot(Eigen::Vector3d(-1, 0, 1).normalized())), 1, 1e-6);
  }
}

}  // namespace
}  // namespace gestalt
