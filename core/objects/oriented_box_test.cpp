// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "oriented_box.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace gestalt {
namespace {

const Eigen::Vector3d up = Eigen::Vector3d(0.2, -0.9, -0.3).normalized();

/// Points on those faces of a box that have a bit in faces: 1 top, 2 front (across its first side), 4 side.
Points box_points(const Eigen::Vector3d& size, double angle, int faces) {
  const auto [x, y] = across(up);
  const Eigen::Vector3d first = std::cos(angle) * x + std::sin(angle) * y, second = up.cross(first);
  Points points;
  constexpr int steps = 40;
  const auto put = [&](double a, double b, double c) {
    points.emplace_back(Eigen::Vector3d(0.1, 0.2, 1) + size.x() * a * first + size.y() * b * second +
                        size.z() * c * up);
  };
  for (int i = 0; i <= steps; ++i)
    for (int k = 0; k <= steps; ++k) {
      const double s = double(i) / steps - 0.5, t = double(k) / steps - 0.5;
      if (faces & 1) put(s, t, 0.5);
      if (faces & 2) put(s, 0.5, t);
      if (faces & 4) put(0.5, s, t);
    }
  return points;
}

void expect_size(const OrientedBox& box, const Eigen::Vector3d& size) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(box.size[i], size[i], 0.02 * size[i] + 1e-6) << i;
}

TEST(OrientedBox, OfATopAndASideHasSidesAndAxesOfTheThing) {
  for (const double angle : {0.0, 0.3, 1.2}) {
    const OrientedBox box = box_around(box_points({0.3, 0.2, 0.1}, angle, 1 | 2), up, {});
    expect_size(box, {0.3, 0.2, 0.1});
    EXPECT_NEAR((box.centre - Eigen::Vector3d(0.1, 0.2, 1)).norm(), 0, 2e-3);
    EXPECT_NEAR((box.axes.transpose() * box.axes - Eigen::Matrix3d::Identity()).norm(), 0, 1e-9);
    EXPECT_NEAR(box.axes.determinant(), 1, 1e-9);
    EXPECT_NEAR((box.axes.col(2) - up).norm(), 0, 1e-12);
  }
}

TEST(OrientedBox, OfTwoSidesAloneIsAlongTheirNormals) {
  const auto [x, y] = across(up);
  const Eigen::Vector3d first = std::cos(0.7) * x + std::sin(0.7) * y;
  expect_size(box_around(box_points({0.3, 0.2, 0.1}, 0.7, 2 | 4), up, {up.cross(first), first}), {0.3, 0.2, 0.1});
}

TEST(OrientedBox, ASlantedSurfaceDoesNotTurnABoxWhoseOutlineIsClear) {
  const auto [x, y] = across(up);
  const Eigen::Vector3d slanted = (std::cos(0.8) * x + std::sin(0.8) * y + 0.2 * up).normalized();
  expect_size(box_around(box_points({0.3, 0.1, 0.1}, 0, 1), up, {slanted}), {0.3, 0.1, 1e-9});
}

TEST(OrientedBox, FewStrayPointsDoNotMakeItLarger) {
  Points points = box_points({0.3, 0.2, 0.1}, 0.3, 1 | 2);
  points.emplace_back(0.1, 0.2, 3);
  const OrientedBox box = box_around(points, up, {});
  EXPECT_LT(box.size.maxCoeff(), 0.45);
}

TEST(OrientedBox, OfNoneOrOnePointIsEmpty) {
  EXPECT_EQ(box_around({}, up, {}).size.norm(), 0);
  EXPECT_EQ(box_around({{0, 0, 1}}, up, {}).size.norm(), 0);
  EXPECT_NEAR((box_around({{0, 0, 1}}, up, {}).centre - Eigen::Vector3d(0, 0, 1)).norm(), 0, 1e-9);
}

}  // namespace
}  // namespace gestalt
