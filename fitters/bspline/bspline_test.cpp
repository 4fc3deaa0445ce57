// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bspline.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>

#include "closest_point.h"
#include "gestalt/core/base/error.h"
#include "surface_fit.h"

namespace gestalt {
namespace {

using Points = std::vector<Eigen::Vector3f>;

/// A surface seen from (0, 0, 0), 1 m away: parameters in [-1, 1] to a point and the normal there, towards the camera.
struct Shape {
  std::function<Eigen::Vector3f(float, float)> point;
  std::function<Eigen::Vector3f(float, float)> normal;
};

/// 0.2 m x 0.1 m, tilted.
const Shape plane{[](float a, float b) { return Eigen::Vector3f(0.1f * a, 0.05f * b, 1 + 0.03f * a - 0.01f * b); },
                  [](float, float) { return Eigen::Vector3f(0.3f, -0.2f, -1).normalized(); }};

/// Radius 4 cm, 10 cm long, that many degrees to each side of the middle.
Shape cylinder(float degrees) {
  const float half = degrees * std::numbers::pi_v<float> / 180;
  return {[half](float a, float b) {
            return Eigen::Vector3f(0.04f * std::sin(half * a), 0.05f * b, 1.04f - 0.04f * std::cos(half * a));
          },
          [half](float a, float) { return Eigen::Vector3f(std::sin(half * a), 0, -std::cos(half * a)); }};
}

/// Cap of 6 cm x 5 cm of a sphere with a radius of 5 cm.
const Shape sphere{[](float a, float b) {
                     const float x = 0.03f * a, y = 0.025f * b;
                     return Eigen::Vector3f(x, y, 1.05f - std::sqrt(0.0025f - x * x - y * y));
                   },
                   [](float a, float b) {
                     const float x = 0.03f * a, y = 0.025f * b;
                     return Eigen::Vector3f(x, y, -std::sqrt(0.0025f - x * x - y * y)).normalized();
                   }};

constexpr float saddle_x = 0.1f, saddle_y = 0.06f, saddle_bend = 2;

/// z = 1 + 2 (x^2 - y^2), 20 cm x 12 cm.
const Shape saddle{
    [](float a, float b) {
      const float x = saddle_x * a, y = saddle_y * b;
      return Eigen::Vector3f(x, y, 1 + saddle_bend * (x * x - y * y));
    },
    [](float a, float b) {
      return Eigen::Vector3f(2 * saddle_bend * saddle_x * a, -2 * saddle_bend * saddle_y * b, -1).normalized();
    }};

constexpr int steps = 30;

float parameter(int i) { return float(i) / steps * 2 - 1; }

/// An even grid of 31 x 31 points, with normal noise along the view.
Points sample(const Shape& shape, float noise = 0) {
  std::mt19937 generator(1);
  std::normal_distribution<float> normal(0, 1);
  Points points;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      points.push_back(shape.point(parameter(i), parameter(j)));
      points.back().z() += noise * normal(generator);
    }
  return points;
}

/// Largest distance of the shape to the model, and largest angle between the normals of both, within that share of the
/// shape around its middle.
struct Deviation {
  float distance = 0;
  float angle = 0;
};

Deviation deviation(const SurfaceModel& model, const Shape& shape, float share = 1) {
  Deviation most;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const float a = share * parameter(i), b = share * parameter(j);
      const Eigen::Vector3f p = shape.point(a, b);
      const SurfaceModel::Foot foot = model.foot(p);
      EXPECT_NEAR((foot.point - p).squaredNorm(), model.squared_distance(p), 1e-9f);
      EXPECT_LT(foot.normal.dot(foot.point), 0);
      most.distance = std::max(most.distance, (foot.point - p).norm());
      most.angle = std::max(most.angle, std::acos(std::min(1.f, foot.normal.dot(shape.normal(a, b)))));
    }
  return most;
}

Bspline fitter(int control_points = 3, double smoothness = 0.1) {
  Bspline::Params params;
  params.control_points_xi = params.control_points_eta = control_points;
  params.smoothness = smoothness;
  return Bspline(params);
}

TEST(Bspline, ReproducesAPlane) {
  for (const int control_points : {3, 6}) {
    const auto model = fitter(control_points).fit(sample(plane));
    ASSERT_TRUE(model);
    const Deviation most = deviation(*model, plane);
    EXPECT_LT(most.distance, 1e-6f);
    EXPECT_LT(most.angle, 1e-3f);
  }
}

TEST(Bspline, MissesACylinderByItsFourthOrder) {
  // z = x^2 / 2R + x^4 / 8R^3 + ...: least squares over |x| <= R sin(theta) leave 8/35 of the Legendre polynomial P4 of
  // the last term, R sin^4(theta) / 35 at the ends, with the slope 10/35 sin^3(theta) there.
  for (const float degrees : {15.f, 25.f, 35.f}) {
    const float sine = std::sin(degrees * std::numbers::pi_v<float> / 180);
    const Deviation most = deviation(*fitter(3, 1e-6).fit(sample(cylinder(degrees))), cylinder(degrees));
    EXPECT_NEAR(most.distance / (0.04f * std::pow(sine, 4.f) / 35), 1, 0.5) << degrees;
    EXPECT_NEAR(most.angle / (10 * std::pow(sine, 3.f) / 35), 1, 0.5) << degrees;
  }
}

TEST(Bspline, FollowsSteepCaps) {
  EXPECT_LT(deviation(*fitter().fit(sample(cylinder(70))), cylinder(70)).distance, 0.004f);
  EXPECT_LT(deviation(*fitter().fit(sample(sphere)), sphere).distance, 0.001f);
}

TEST(Bspline, FollowsThemBetterWithMoreControlPoints) {
  EXPECT_LT(deviation(*fitter(6).fit(sample(cylinder(70))), cylinder(70)).distance, 0.0015f);
  EXPECT_LT(deviation(*fitter(6).fit(sample(cylinder(40))), cylinder(40)).angle, 0.04f);
  EXPECT_LT(deviation(*fitter(6).fit(sample(sphere)), sphere).distance, 0.0002f);
  EXPECT_LT(deviation(*fitter(6).fit(sample(sphere)), sphere).angle, 0.05f);
}

TEST(Bspline, HasTheNormalsOfASaddle) { EXPECT_LT(deviation(*fitter().fit(sample(saddle)), saddle).angle, 0.01f); }

TEST(Bspline, NoiseIsAveragedOut) {
  // 961 points, 9 control points: the surface moves by about noise / sqrt(961 / 9), and by three times that in corners.
  constexpr float noise = 0.001f;
  for (const Shape& shape : {plane, cylinder(30), saddle}) {
    const auto model = fitter().fit(sample(shape, noise));
    ASSERT_TRUE(model);
    EXPECT_LT(deviation(*model, shape, 0.5f).distance, 0.00025f);
    EXPECT_LT(deviation(*model, shape).distance, 0.0008f);
    EXPECT_LT(deviation(*model, shape, 0.5f).angle, 0.03f);
  }
}

TEST(Bspline, ControlPointsOfASaddleAreItsBlossom) {
  // With x = L (2 xi - 1), x^2 has the Bezier coefficients L^2, -L^2, L^2.
  const auto model = fitter(3, 1e-6).fit(sample(saddle));
  ASSERT_TRUE(model);
  const BsplineSurface& surface = dynamic_cast<const BsplineModel&>(*model).surface();
  ASSERT_EQ(surface.points.size(), 9u);
  for (int j = 0; j < 3; ++j)
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d& b = surface.control_point(i, j);
      const double xx = i == 1 ? -1 : 1, yy = j == 1 ? -1 : 1;
      EXPECT_NEAR(std::abs(b.x()), std::abs(saddle_x * (i - 1)), 2e-4);
      EXPECT_NEAR(std::abs(b.y()), std::abs(saddle_y * (j - 1)), 2e-4);
      EXPECT_NEAR(b.z(), 1 + saddle_bend * (saddle_x * saddle_x * xx - saddle_y * saddle_y * yy), 2e-4);
    }
}

TEST(Bspline, SmoothnessFlattensLikeThatManyPoints) {
  // z = bend x^2 on a grid of n points: as many points that vote for the plane leave half of the bend.
  const Shape trough{[](float a, float b) { return Eigen::Vector3f(0.1f * a, 0.05f * b, 1 + 0.005f * a * a); }, {}};
  const Points points = sample(trough);
  const auto sag = [&](double weight) {
    const BsplineSurface surface =
        dynamic_cast<const BsplineModel&>(*fitter(3, weight * double(points.size())).fit(points)).surface();
    return surface.point(0, 0.5).z() - surface.point(0.5, 0.5).z();
  };
  EXPECT_NEAR(sag(1e-9), 0.005, 5e-5);
  EXPECT_NEAR(sag(1), 0.0025, 0.0003);
  EXPECT_LT(sag(1000), 0.0001);
}

TEST(Bspline, OfMergedPatchesIsNearlyThatOfAllPoints) {
  Points left, right;
  const Points all = sample(cylinder(50), 0.0005f);
  for (const Eigen::Vector3f& p : all) (p.x() < 0.005f ? left : right).push_back(p);
  const Bspline bspline = fitter();
  const auto direct = bspline.fit(all),
             merged = bspline.fit_merged(*bspline.fit(left), left, *bspline.fit(right), right);
  ASSERT_TRUE(direct && merged);
  for (const Eigen::Vector3f& p : all) {
    EXPECT_LT((direct->foot(p).point - merged->foot(p).point).norm(), 0.0003f);
    EXPECT_GT(direct->foot(p).normal.dot(merged->foot(p).normal), 0.999f);
  }
  EXPECT_LE(dynamic_cast<const BsplineModel&>(*merged).digest().means.size(), 144u);
}

TEST(Bspline, InsertedKnotsFollowADetail) {
  const Shape ripple{[](float a, float b) { return Eigen::Vector3f(0.1f * a, 0.05f * b, 1 + 0.01f * std::cos(6 * a)); },
                     {}};
  const Points points = sample(ripple);
  const auto rms = [&](int insertions) {
    Bspline::Params params;
    params.knot_insertions = insertions;
    const auto model = Bspline(params).fit(points);
    double sum = 0;
    for (const Eigen::Vector3f& p : points) sum += double(model->squared_distance(p));
    return std::sqrt(sum / double(points.size()));
  };
  EXPECT_GT(rms(0), 0.004);
  EXPECT_LT(rms(5), 0.001);
  Bspline::Params params;
  params.knot_insertions = 5;
  EXPECT_EQ(Bspline(params).parameter_count(), 3 * 8 * 8);
}

TEST(Bspline, InsertingAKnotKeepsTheSurface) {
  BsplineSurface surface = dynamic_cast<const BsplineModel&>(*fitter(5).fit(sample(sphere))).surface();
  const BsplineSurface before = surface;
  surface.insert_knot_xi(0.4);
  surface.insert_knot_eta(0.9);
  surface.insert_knot_eta(0.9);
  EXPECT_EQ(surface.columns(), 6);
  EXPECT_EQ(surface.rows(), 7);
  for (double xi = 0; xi <= 1; xi += 0.05)
    for (double eta = 0; eta <= 1; eta += 0.05)
      EXPECT_LT((surface.point(xi, eta) - before.point(xi, eta)).norm(), 1e-12);
}

TEST(Bspline, RefusesWhatDeterminesNoSurfaceAndSaysWhy) {
  const Bspline bspline = fitter();
  Points line, speck(8, {0, 0, 1}), strip, tube, leaf;
  for (int i = 0; i < 60; ++i) {
    const float t = float(i) / 60;
    line.emplace_back(t, 0.2f * t, 1 + t);
    speck[std::size_t(i) % 8].x() += 0.001f * float(i % 3);
    strip.emplace_back(t, 0.001f * float(i % 2), 1);
  }
  for (int i = 0; i < 72; ++i)
    for (int j = 0; j < 40; ++j) {
      const float angle = 2 * std::numbers::pi_v<float> * float(i) / 72;
      tube.emplace_back(0.01f * float(j), 0.1f * std::sin(angle), 1 + 0.1f * std::cos(angle));
      // Two leaves of paper, one behind the other.
      leaf.emplace_back(0.002f * float(i), 0.002f * float(j), 1 + 0.02f * float((i + j) % 2));
    }
  EXPECT_EQ(bspline.refusal({}), "too few points");
  EXPECT_EQ(bspline.refusal(speck), "too few points");
  EXPECT_EQ(bspline.refusal(line), "collinear points");
  EXPECT_EQ(bspline.refusal(strip), "collinear points");
  EXPECT_EQ(bspline.refusal(Points(50, {0, 0, 1})), "collinear points");
  EXPECT_EQ(bspline.refusal(tube), "points as thick as they are wide");
  EXPECT_EQ(bspline.refusal(leaf), "folded over its principal plane");
  for (const Points& points : {Points{}, speck, line, strip, tube, leaf}) EXPECT_EQ(bspline.fit(points), nullptr);
  for (const Shape& shape : {plane, cylinder(80), sphere, saddle}) EXPECT_EQ(bspline.refusal(sample(shape)), "");
}

TEST(Bspline, EndsAtItsPatch) {
  const auto model = fitter().fit(sample(saddle));
  const SurfaceModel::Foot foot = model->foot({1, 0, 1 + saddle_bend * saddle_x * saddle_x});
  EXPECT_NEAR(foot.point.x(), saddle_x, 1e-3);
  EXPECT_NEAR(foot.point.y(), 0, 1e-3);
  for (const float far : {1e3f, 1e18f, 3e38f})
    for (const Eigen::Vector3f& p : Points{{far, 0, 1}, {-far, far, -far}, {0, 0, far}}) {
      const SurfaceModel::Foot end = model->foot(p);
      EXPECT_TRUE(end.point.allFinite() && end.normal.allFinite() && std::isfinite(model->squared_distance(p)));
      EXPECT_LT(end.point.norm(), 2);
    }
}

TEST(Bspline, RefusesAGridSmallerThanItsDegree) {
  Bspline::Params params;
  params.degree = 3;
  try {
    const Bspline bspline(params);
    FAIL();
  } catch (const ConfigError& error) {
    EXPECT_NE(std::string(error.what()).find("control_points_xi = 3"), std::string::npos) << error.what();
  }
}

TEST(Bspline, TellsItsParametersAsJson) {
  Bspline::Params params;
  params.control_points_xi = 4;
  const nlohmann::json json = Bspline(params).fit(sample(saddle))->to_json();
  EXPECT_EQ(json.at("degree"), 2);
  EXPECT_EQ(json.at("knots_xi"), (std::vector<double>{0, 0, 0, 0.5, 1, 1, 1}));
  EXPECT_EQ(json.at("knots_eta"), (std::vector<double>{0, 0, 0, 1, 1, 1}));
  EXPECT_EQ(json.at("control_points").size(), 3u);
  EXPECT_EQ(json.at("control_points").at(0).size(), 4u);
}

TEST(ClosestPoint, IsFoundFromABadStart) {
  // Half a pipe: from its axis, every place of the pipe is as near as any other; off the axis one is nearest.
  const auto model = fitter(6).fit(sample(cylinder(85)));
  const BsplineSurface& surface = dynamic_cast<const BsplineModel&>(*model).surface();
  for (const double angle : {-1.2, -0.5, 0.0, 0.9}) {
    const Eigen::Vector3d p(0.01 * std::sin(angle), 0.01, 1.04 - 0.01 * std::cos(angle));
    double nearest = 1;
    for (int i = 0; i <= 1000; ++i)
      for (int j = 0; j <= 50; ++j) nearest = std::min(nearest, (surface.point(i / 1000.0, j / 50.0) - p).norm());
    for (const Eigen::Vector2d& start : {Eigen::Vector2d(0.5, 0.5), Eigen::Vector2d(1, 0)})
      EXPECT_LT(std::sqrt(closest_point(surface, p, start).squared_distance), nearest + 0.0012) << angle;
  }
}

TEST(ClosestPoint, NeverEndsFartherThanItStarts) {
  const BsplineSurface surface = dynamic_cast<const BsplineModel&>(*fitter(6).fit(sample(saddle))).surface();
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-0.5, 0.5);
  for (int i = 0; i < 500; ++i) {
    const Eigen::Vector3d p(uniform(generator), uniform(generator), 1 + uniform(generator));
    const Eigen::Vector2d start(0.5 + uniform(generator), 0.5 + uniform(generator));
    const ClosestPoint closest = closest_point(surface, p, start);
    EXPECT_LE(closest.squared_distance, (surface.point(start.x(), start.y()) - p).squaredNorm());
    EXPECT_NEAR(closest.squared_distance,
                (surface.point(closest.parameters.x(), closest.parameters.y()) - p).squaredNorm(), 1e-12);
  }
}

}  // namespace
}  // namespace gestalt
