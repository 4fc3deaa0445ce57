// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "quadric.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace {

using Points = std::vector<Eigen::Vector3f>;

/// The side of an upright mug of 4 cm radius towards the camera, 60 degrees of it.
Points mug(float noise = 0) {
  Points points;
  for (int i = -30; i <= 30; ++i)
    for (int j = 0; j < 20; ++j) {
      const float angle = float(i) * float(M_PI) / 180, radius = 0.04f + ((i + j) % 2 ? noise : -noise);
      points.emplace_back(radius * std::sin(angle), 0.004f * float(j), 1 - radius * std::cos(angle));
    }
  return points;
}

TEST(Quadric, FollowsTheWallOfAMug) {
  const auto model = Quadric({}).fit(mug());
  double squared = 0;
  for (const Eigen::Vector3f& p : mug()) squared += model->squared_distance(p) / double(mug().size());
  EXPECT_LT(std::sqrt(squared), 1e-4);  // a plane: 1.6 mm
}

TEST(Quadric, LiesInTheMiddleOfNoisyPoints) {
  const auto foot = Quadric({}).fit(mug(0.001f))->foot({0, 0.04f, 0.9f});
  EXPECT_LT((foot.point - Eigen::Vector3f(0, 0.04f, 0.96f)).norm(), 5e-4f);
  EXPECT_LT(foot.normal.z(), -0.99f);
}

TEST(Quadric, TheFootIsNearest) {
  const auto model = Quadric({}).fit(mug());
  const Eigen::Vector3f p(0.03f, 0.02f, 0.95f);
  const auto foot = model->foot(p);
  EXPECT_GT((p - foot.point).normalized().dot(foot.normal), 0.999f);
}

TEST(Quadric, TellsWhyItRefuses) {
  const Quadric fitter({});
  Points line;
  for (int i = 0; i < 20; ++i) line.emplace_back(0.01f * float(i), 0, 1);
  EXPECT_EQ(fitter.fit(line), nullptr);
  EXPECT_EQ(fitter.refusal(line), "collinear points");
  EXPECT_EQ(fitter.refusal({}), "fewer than 12 points");
}

}  // namespace
