// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mean_normals.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <numbers>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

std::array<double, 2> normals(const test::KnownScene& known, const MeanNormals::Params& params = {}) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  std::array<double, 2> values{-1, -1};
  (*MeanNormals(params).bind(scene))({0, 1, nullptr}, values);
  return values;
}

/// Half of an upright cylinder: its normal turns from the left over the camera's direction to the right as x goes from
/// -radius to radius.
class HalfCylinder final : public SurfaceModel {
 public:
  explicit HalfCylinder(float radius) : radius_(radius) {}
  std::string type() const override { return "half cylinder"; }
  Foot foot(const Eigen::Vector3f& p) const override {
    const float angle = p.x() / radius_ * float(std::numbers::pi) / 2;
    return {p, {std::sin(angle), 0, -std::cos(angle)}};
  }
  nlohmann::json to_json() const override { return {}; }

 private:
  float radius_;
};

TEST(MeanNormals, OfTheFacesOfABoxAreARightAngleApart) {
  const auto [r_nm, r_nv] = normals(test::ridge(true));
  EXPECT_NEAR(r_nm, std::numbers::pi / 2, 1e-6);
  EXPECT_EQ(r_nv, 0);
}

TEST(MeanNormals, OfParallelPlanesAreTheSame) {
  const auto [r_nm, r_nv] = normals(test::rectangle_before_wall());
  EXPECT_NEAR(r_nm, 0, 1e-6);
  EXPECT_NEAR(r_nv, 0, 1e-6);
}

TEST(MeanNormals, TellACylinderFromAPlaneByVariance) {
  auto scene = test::rectangle_before_wall();
  // 120 px at 1 m from the image's middle to both sides.
  scene.surfaces.surfaces[1].model = std::make_shared<HalfCylinder>(float(60 / 525.0));
  const auto [r_nm, r_nv] = normals(scene, {"fitted", 120 * 120});
  EXPECT_NEAR(r_nm, 0, 0.01);
  EXPECT_NEAR(r_nv, 1 - std::pow(2 / std::numbers::pi, 2), 0.01);
}

TEST(MeanNormals, CanBeThoseOfTheSignalLevel) {
  auto scene = test::rectangle_before_wall();
  // Half of the rectangle's normals lean left by 0.2 rad, half of them right.
  for (int v = 180; v < 300; ++v)
    for (int u = 260; u < 380; ++u) {
      const float angle = u < 320 ? -0.2f : 0.2f;
      scene.patches.normals(v, u) = {std::sin(angle), 0, -std::cos(angle)};
    }
  EXPECT_NEAR(normals(scene)[1], 0, 1e-6);
  EXPECT_NEAR(normals(scene, {"measured", 120 * 120})[1], std::pow(std::sin(0.2), 2), 1e-4);
}

TEST(MeanNormals, StayWhenTheSceneMoves) {
  for (const char* which : {"fitted", "measured"}) {
    const auto before = normals(test::ridge(true), {which, 256});
    const auto after = normals(test::moved(test::ridge(true), test::some_motion()), {which, 256});
    EXPECT_NEAR(before[0], after[0], 1e-5);
    EXPECT_NEAR(before[1], after[1], 1e-5);
  }
}

}  // namespace
}  // namespace gestalt
