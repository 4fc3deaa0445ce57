// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shape_kind.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>

#include "gestalt/core/scene/moments.h"

namespace gestalt {
namespace {

constexpr double tolerance = 0.003;  // m
const Eigen::Vector3d up(0, -1, 0);  // of a table seen from the side

/// Points of place(s, t), s and t in [0, 1], with noise along the view.
Facet facet(const std::function<Eigen::Vector3d(double, double)>& place, double noise = 0.001) {
  std::mt19937 random(1);
  std::normal_distribution<double> error(0, noise);
  Facet made;
  Moments moments;
  for (int i = 0; i <= 30; ++i)
    for (int k = 0; k <= 30; ++k) {
      made.points.push_back(Eigen::Vector3d(0, 0, 1) + place(i / 30.0, k / 30.0) +
                            Eigen::Vector3d(0, 0, error(random)));
      moments.add(made.points.back() - made.points.front());
    }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(moments.covariance());
  made.rms = std::sqrt(std::max(0.0, axes.eigenvalues()[0]));
  made.normal = axes.eigenvectors().col(0);
  return made;
}

ShapeKind kind_of(const std::vector<Facet>& facets, double top = 0.1) {
  Points points, normals;
  for (const Facet& one : facets) {
    points.insert(points.end(), one.points.begin(), one.points.end());
    normals.push_back(one.normal);
  }
  Support support;
  support.normal = up, support.top = top;
  return find_kind(facets, box_around(points, up, normals), support, tolerance);
}

/// A strip of a standing can's side, radius 4 cm, between two angles from the view.
Facet strip(double from, double to) {
  return facet([=](double s, double t) {
    const double angle = from + (to - from) * s;
    return Eigen::Vector3d(0.04 * std::sin(angle), 0.1 * t, -0.04 * std::cos(angle));
  });
}

const Facet front = facet([](double s, double t) { return Eigen::Vector3d(0.2 * s, 0.1 * t, 0); });
const Facet top = facet([](double s, double t) { return Eigen::Vector3d(0.2 * s, 0, 0.1 * t); });

TEST(ShapeKind, ASheetOnTheTableIsAPlaneAndOneThatStandsIsABox) {
  EXPECT_EQ(kind_of({top}, 0.005), ShapeKind::plane);
  EXPECT_EQ(kind_of({front}, 0.1), ShapeKind::box);
}

TEST(ShapeKind, TwoFacesAtRightAnglesAreABox) { EXPECT_EQ(kind_of({front, top}), ShapeKind::box); }

TEST(ShapeKind, StripsOfASideAreACylinderStandingOrLying) {
  const std::vector<Facet> standing{strip(-1.2, -0.4), strip(-0.4, 0.4), strip(0.4, 1.2)};
  EXPECT_EQ(kind_of(standing), ShapeKind::cylinder);
  const Facet lying = facet([](double s, double t) {
    const double angle = 2.4 * s - 1.2;
    return Eigen::Vector3d(0.12 * t, 0.04 * std::sin(angle), -0.04 * std::cos(angle));
  });
  EXPECT_EQ(kind_of({lying}), ShapeKind::cylinder);
}

TEST(ShapeKind, ALidBelongsToACylinder) {
  const Facet lid = facet(
      [](double s, double t) { return Eigen::Vector3d(0.04 * s * std::sin(7 * t), 0, -0.04 * s * std::cos(7 * t)); });
  EXPECT_EQ(kind_of({strip(-1.2, -0.4), strip(-0.4, 0.4), strip(0.4, 1.2), lid}), ShapeKind::cylinder);
}

TEST(ShapeKind, ABallIsASphere) {
  const Facet ball = facet([](double s, double t) {
    const double a = 2 * s - 1, b = 2 * t - 1;
    return Eigen::Vector3d(0.05 * std::sin(a) * std::cos(b), 0.05 * std::sin(b), -0.05 * std::cos(a) * std::cos(b));
  });
  EXPECT_EQ(kind_of({ball}), ShapeKind::sphere);
}

TEST(ShapeKind, WhatFitsNoShapeIsOther) {
  const Facet saddle = facet([](double s, double t) {
    return Eigen::Vector3d(0.2 * s, 0.2 * t, 0.3 * (s - 0.5) * (s - 0.5) - 0.3 * (t - 0.5) * (t - 0.5));
  });
  EXPECT_EQ(kind_of({saddle}), ShapeKind::other);
  EXPECT_EQ(find_kind({}, {}, {}, tolerance), ShapeKind::other);
}

TEST(ShapeKind, APieceOfAPlaneIsNotALargeCircle) {
  const Facet bent = facet([](double s, double t) { return Eigen::Vector3d(0.05 * s, 0.1 * t, 0.02 * s * s); });
  EXPECT_NE(kind_of({bent}), ShapeKind::sphere);
}

}  // namespace
}  // namespace gestalt
