// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/bspline_surface.h"

#include <gtest/gtest.h>

#include <numeric>

namespace gestalt {
namespace {

double sum(const BsplineBasis::Values& values) { return std::accumulate(values.begin(), values.end(), 0.0); }

TEST(BsplineBasis, OfOneSpanIsBernsteins) {
  const BsplineBasis b = bspline_basis(2, clamped_knots(2, 3), 0.3);
  EXPECT_EQ(b.first, 0);
  EXPECT_NEAR(b.value[0], 0.7 * 0.7, 1e-15);
  EXPECT_NEAR(b.value[1], 2 * 0.3 * 0.7, 1e-15);
  EXPECT_NEAR(b.value[2], 0.3 * 0.3, 1e-15);
  EXPECT_NEAR(b.first_derivative[0], -2 * 0.7, 1e-15);
  EXPECT_NEAR(b.first_derivative[1], 2 - 4 * 0.3, 1e-15);
  EXPECT_NEAR(b.second_derivative[1], -4, 1e-14);
}

TEST(BsplineBasis, SumsToOneAtAnyPlaceOfAnyDegree) {
  for (int degree = 1; degree <= BsplineBasis::largest_degree; ++degree) {
    std::vector<double> knots = clamped_knots(degree, degree + 4);
    knots.insert(knots.begin() + degree + 2, 0.25);  // a double one
    for (const double x : {-1.0, 0.0, 0.1, 0.25, 0.5, 0.99, 1.0, 2.0}) {
      const BsplineBasis b = bspline_basis(degree, knots, x);
      EXPECT_NEAR(sum(b.value), 1, 1e-13) << degree << " at " << x;
      EXPECT_NEAR(sum(b.first_derivative), 0, 1e-11);
      EXPECT_NEAR(sum(b.second_derivative), 0, 1e-9);
      EXPECT_GE(b.first, 0);
      EXPECT_LE(b.first + degree, int(knots.size()) - degree - 2);
    }
  }
}

/// Degree 3, 5 x 4 control points at odd places.
BsplineSurface crumpled() {
  BsplineSurface surface{3, clamped_knots(3, 5), clamped_knots(3, 4), {}};
  for (int j = 0; j < 4; ++j)
    for (int i = 0; i < 5; ++i) surface.points.emplace_back(i + 0.1 * j, j - 0.2 * i, (i * i + 3 * j * i) % 5);
  return surface;
}

TEST(BsplineSurface, EndsInItsOuterControlPoints) {
  const BsplineSurface surface = crumpled();
  EXPECT_LT((surface.point(0, 0) - surface.points.front()).norm(), 1e-12);
  EXPECT_LT((surface.point(1, 0) - surface.points[4]).norm(), 1e-12);
  EXPECT_LT((surface.point(1, 1) - surface.points.back()).norm(), 1e-12);
}

TEST(BsplineSurface, DerivativesAreThoseOfItsPoints) {
  const BsplineSurface s = crumpled();
  constexpr double h = 1e-4;
  for (const double x : {0.2, 0.45, 0.8})
    for (const double y : {0.1, 0.6}) {
      const auto d = s.derivatives(x, y);
      EXPECT_LT((d.point - s.point(x, y)).norm(), 1e-12);
      EXPECT_LT((d.xi - (s.point(x + h, y) - s.point(x - h, y)) / (2 * h)).norm(), 1e-5);
      EXPECT_LT((d.eta - (s.point(x, y + h) - s.point(x, y - h)) / (2 * h)).norm(), 1e-5);
      EXPECT_LT((d.xi_xi - (s.point(x + h, y) - 2 * d.point + s.point(x - h, y)) / (h * h)).norm(), 1e-4);
      EXPECT_LT((d.eta_eta - (s.point(x, y + h) - 2 * d.point + s.point(x, y - h)) / (h * h)).norm(), 1e-4);
      EXPECT_LT(
          (d.xi_eta - (s.point(x + h, y + h) - s.point(x + h, y - h) - s.point(x - h, y + h) + s.point(x - h, y - h)) /
                          (4 * h * h))
              .norm(),
          1e-4);
    }
}

TEST(BsplineSurface, KeepsItsShapeWhenKnotsAreInserted) {
  const BsplineSurface before = crumpled();
  BsplineSurface after = before;
  after.insert_knot_xi(0.3);
  after.insert_knot_xi(0.5);  // there is one already
  after.insert_knot_eta(0.7);
  EXPECT_EQ(after.columns(), 7);
  EXPECT_EQ(after.rows(), 5);
  EXPECT_EQ(after.points.size(), 35u);
  for (double x = 0; x <= 1; x += 0.05)
    for (double y = 0; y <= 1; y += 0.05) EXPECT_LT((after.point(x, y) - before.point(x, y)).norm(), 1e-12);
}

}  // namespace
}  // namespace gestalt
