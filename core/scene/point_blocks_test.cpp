// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/point_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

namespace gestalt {
namespace {

/// Points along a curve, as those of an outline, on a grid of half units so that many distances are equal.
Eigen::Matrix3Xf curve(int count, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_int_distribution<int> step(-2, 2), start(-30, 30);
  Eigen::Matrix3Xf points(3, count);
  Eigen::Vector3f p(float(start(random)), float(start(random)), float(start(random)));
  for (int i = 0; i < count; ++i) {
    p += Eigen::Vector3f(float(step(random)), float(step(random)), float(step(random))) / 2;
    points.col(i) = p;
  }
  return points;
}

float squared(const Eigen::Vector3f& d) { return d.x() * d.x() + d.y() * d.y() + d.z() * d.z(); }

/// By a look at all pairs.
NearestPoint nearest(const Eigen::Matrix3Xf& from, int i, const Eigen::Matrix3Xf& to) {
  NearestPoint nearest{std::numeric_limits<float>::infinity(), i, 0};
  for (int j = 0; j < to.cols(); ++j)
    if (const float d = squared(from.col(i) - to.col(j)); d < nearest.squared_distance)
      nearest.squared_distance = d, nearest.to = j;
  return nearest;
}

TEST(PointBlocks, GiveWhatALookAtAllPairsGives) {
  unsigned seed = 0;
  for (const int m : {1, 7, 8, 9, 48, 64, 65, 128, 200})
    for (const int n : {1, 8, 15, 64, 127, 128}) {
      const Eigen::Matrix3Xf a = curve(m, ++seed), b = curve(n, ++seed);
      float smallest = std::numeric_limits<float>::infinity(), largest = 0;
      for (int i = 0; i < m; ++i)
        for (int j = 0; j < n; ++j) {
          const float d = squared(a.col(i) - b.col(j));
          smallest = std::min(smallest, d);
          largest = std::max(largest, d);
        }
      EXPECT_EQ(smallest_squared_distance(PointBlocks(a), PointBlocks(b)), smallest) << m << ' ' << n;
      EXPECT_EQ(largest_squared_distance(PointBlocks(a), PointBlocks(b)), largest) << m << ' ' << n;
      std::vector<NearestPoint> all = nearest_points(PointBlocks(a), PointBlocks(b), 1);
      ASSERT_EQ(all.size(), std::size_t(m));
      std::sort(all.begin(), all.end(), [](const NearestPoint& x, const NearestPoint& y) { return x.from < y.from; });
      for (int i = 0; i < m; ++i) {
        const NearestPoint expected = nearest(a, i, b), &found = all[std::size_t(i)];
        EXPECT_EQ(found.from, i);
        EXPECT_EQ(found.to, expected.to) << m << ' ' << n << ' ' << i;
        EXPECT_EQ(found.squared_distance, expected.squared_distance) << m << ' ' << n << ' ' << i;
      }
    }
}

}  // namespace
}  // namespace gestalt
