// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plane.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace gestalt {
namespace {

using Points = std::vector<Eigen::Vector3f>;

Points grid(const Eigen::Vector3f& centre, const Eigen::Vector3f& x, const Eigen::Vector3f& y, int steps) {
  Points points;
  for (int i = -steps; i <= steps; ++i)
    for (int j = -steps; j <= steps; ++j) points.push_back(centre + float(i) * x + float(j) * y);
  return points;
}

TEST(Plane, FindsTheNormalTowardsTheCamera) {
  const Eigen::Vector3f normal = Eigen::Vector3f(0.3f, -0.8f, -0.5f).normalized();
  const Eigen::Vector3f x = normal.unitOrthogonal() * 0.01f, y = normal.cross(x);
  const Eigen::Vector3f centre(0.1f, 0.2f, 0.9f);
  const auto model = Plane({}).fit(grid(centre, x, y, 10));
  const auto foot = model->foot(centre + 0.02f * normal + 3 * x);
  EXPECT_LT((foot.normal - normal).norm(), 1e-4f);
  EXPECT_LT((foot.point - (centre + 3 * x)).norm(), 1e-5f);
  EXPECT_NEAR(model->squared_distance(centre + 0.02f * normal), 0.0004f, 1e-6f);
}

TEST(Plane, OfNoPointsIsNull) { EXPECT_EQ(Plane({}).fit({}), nullptr); }

TEST(Plane, OfOnePointFacesTheCamera) {
  const Points one{{0, 0.6f, 0.8f}};
  const auto foot = Plane({}).fit(one)->foot({0, 0, 0});
  EXPECT_LT((foot.normal - Eigen::Vector3f(0, -0.6f, -0.8f)).norm(), 1e-5f);
}

TEST(Plane, OfCollinearPointsContainsTheLineAndFacesTheCamera) {
  Points line;
  for (int i = 0; i < 20; ++i) line.emplace_back(0.01f * float(i), 0, 1);
  const auto model = Plane({}).fit(line);
  const auto foot = model->foot(line.front());
  EXPECT_NEAR(foot.normal.x(), 0, 1e-4);
  EXPECT_LT(foot.normal.z(), -0.99f);
  EXPECT_LT(model->squared_distance(line.back()), 1e-10f);
}

TEST(Plane, OfAPatchThousandsOfTimesLongerThanWideHasANormal) {
  const Points points{{0, 0, 1e-3F}, {2e-6F, 0, 1e-3F}, {0, 2e-6F, 1e-3F}, {-5000, -4000, 1000}};
  const auto foot = Plane({}).fit(points)->foot(points[3]);
  EXPECT_TRUE(foot.point.allFinite());
  EXPECT_NEAR(foot.normal.norm(), 1, 1e-5F);
}

TEST(Plane, MergedFromMomentsEqualsAFitToAllPoints) {
  const Points a = grid({0, 0, 1}, {0.01f, 0, 0.002f}, {0, 0.01f, 0}, 8);
  const Points b = grid({0.2f, 0, 1.05f}, {0.01f, 0, 0}, {0, 0.01f, 0.001f}, 5);
  Points both = a;
  both.insert(both.end(), b.begin(), b.end());
  const Plane plane({});
  const auto merged = plane.fit_merged(*plane.fit(a), a, *plane.fit(b), b), direct = plane.fit(both);
  for (const Eigen::Vector3f& p : both) {
    EXPECT_LT((merged->foot(p).normal - direct->foot(p).normal).norm(), 1e-5f);
    EXPECT_NEAR(merged->squared_distance(p), direct->squared_distance(p), 1e-8f);
  }
}

}  // namespace
}  // namespace gestalt
