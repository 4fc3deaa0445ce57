// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <nlohmann/json.hpp>

#include "subjects.h"

namespace gestalt::conformance {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// A grid of points on the plane through (0, 0, 1) with that normal.
Points grid(const Eigen::Vector3f& normal, int columns = 20, int rows = 20) {
  Points points;
  for (int v = 0; v < rows; ++v)
    for (int u = 0; u < columns; ++u) {
      const Eigen::Vector3f ray(0.01f * float(u - columns / 2), 0.01f * float(v - rows / 2), 1);
      points.push_back(ray * (normal.z() / normal.dot(ray)));
    }
  return points;
}

void expect_sound(const SurfaceModel& model, const Eigen::Vector3f& p) {
  const SurfaceModel::Foot foot = model.foot(p);
  ASSERT_TRUE(foot.point.allFinite() && foot.normal.allFinite()) << "at " << p.transpose();
  EXPECT_NEAR(foot.normal.norm(), 1, 1e-4);
  EXPECT_GE(model.squared_distance(p), 0);
  EXPECT_NEAR(std::sqrt(model.squared_distance(p)), (foot.point - p).norm(), 1e-4);
}

/// The model must pass through all points, with normals towards the camera.
void expect_through(const SurfaceModel& model, const Points& points) {
  for (const Eigen::Vector3f& p : points) {
    expect_sound(model, p);
    EXPECT_LT(model.squared_distance(p), 1e-4f * 1e-4f);
    EXPECT_LT(model.foot(p).normal.dot(p), 0);
  }
}

class FitterContract : public SubjectTest<Fitter> {
 protected:
  const std::vector<Eigen::Vector3f> normals_{{0, 0, -1}, {0.6f, 0, -0.8f}, {0, 0.8f, -0.6f}, {-0.5f, -0.5f, -0.7f}};
};

TEST_P(FitterContract, CostsParameters) { EXPECT_GT(subject_->parameter_count(), 0); }

TEST_P(FitterContract, FitsAPlaneExactly) {
  for (const Eigen::Vector3f& normal : normals_) {
    const Points points = grid(normal);
    const auto model = subject_->fit(points);
    ASSERT_TRUE(model);
    expect_through(*model, points);
    EXPECT_GT(model->foot(points.front()).normal.dot(normal.normalized()), 0.999f);
  }
}

TEST_P(FitterContract, ModelsTellTheirType) {
  const auto model = subject_->fit(grid(normals_[1]));
  ASSERT_TRUE(model);
  EXPECT_EQ(model->type(), GetParam().name);
  EXPECT_EQ(model->to_json().value("type", ""), GetParam().name);
}

TEST_P(FitterContract, IsFiniteFarFromThePatch) {
  const auto model = subject_->fit(grid(normals_[1]));
  ASSERT_TRUE(model);
  for (const Eigen::Vector3f& p : Points{{0, 0, 0.1f}, {3, -2, 5}, {-10, 10, 10}, {0, 0, 0}}) expect_sound(*model, p);
}

TEST_P(FitterContract, FitsTwoMergedPatches) {
  const Points points = grid(normals_[1]);
  const Points first(points.begin(), points.begin() + 150), second(points.begin() + 150, points.end());
  const auto a = subject_->fit(first), b = subject_->fit(second);
  ASSERT_TRUE(a && b);
  const auto merged = subject_->fit_merged(*a, first, *b, second);
  ASSERT_TRUE(merged);
  expect_through(*merged, points);
}

TEST_P(FitterContract, GivesASoundModelOrNoneForDegeneratePatches) {
  Points line, corner{{0, 0, 1}, {0.01f, 0, 1}, {0, 0.01f, 1}};
  for (int i = 0; i < 30; ++i) line.push_back({0.01f * float(i), 0, 1});
  const std::vector<Points> patches{
      {{0.1f, 0, 1}}, {{0, 0, 1}, {0.01f, 0, 1}}, line, corner, Points(50, Eigen::Vector3f(0, 0.1f, 1))};
  for (const Points& points : patches) {
    SCOPED_TRACE(std::to_string(points.size()) + " points");
    if (const auto model = subject_->fit(points))
      for (const Eigen::Vector3f& p : points) expect_sound(*model, p);
  }
}

TEST_P(FitterContract, GivesTheSameTwiceAndForAnyNumberOfThreads) {
  Points points = grid(normals_[2]);
  for (std::size_t i = 0; i < points.size(); ++i) points[i].z() += 0.002f * float(i * i % 7);
  const auto distances = [&] {
    std::vector<float> d;
    const auto model = subject_->fit(points);
    for (const Eigen::Vector3f& p : points) d.push_back(model ? model->squared_distance(p) : -1);
    return d;
  };
  const auto one = with_threads(1, distances);
  EXPECT_EQ(with_threads(1, distances), one);
  EXPECT_EQ(with_threads(8, distances), one);
}

GESTALT_CONFORMANCE(FitterContract, "fitter");

}  // namespace
}  // namespace gestalt::conformance
