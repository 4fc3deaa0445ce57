// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "gestalt/core/base/error.h"
#include "gestalt/io/result/parametric_surface.h"

namespace gestalt {
namespace {

using Point = Eigen::Vector2d;

/// Sum of the areas of the triangles; every one must turn counter-clockwise.
double area(const std::vector<TrimmingOutline>& outlines) {
  std::vector<Point> points;
  for (const TrimmingOutline& outline : outlines)
    points.insert(points.end(), outline.vertices.begin(), outline.vertices.end());
  double sum = 0;
  TriangulationBudget budget;
  for (const auto& [a, b, c] : triangulate(outlines, budget)) {
    const Point u = points[std::size_t(b)] - points[std::size_t(a)],
                v = points[std::size_t(c)] - points[std::size_t(a)];
    const double twice = u.x() * v.y() - u.y() * v.x();
    EXPECT_GT(twice, 0);
    sum += twice / 2;
  }
  return sum;
}

TrimmingOutline square(double left, double top, double size, bool hole = false) {
  return {hole, {{left, top}, {left + size, top}, {left + size, top + size}, {left, top + size}}};
}

TrimmingOutline star(int points, double inner, double outer) {
  TrimmingOutline outline;
  for (int i = 0; i < 2 * points; ++i) {
    const double angle = std::numbers::pi * i / points, radius = i % 2 ? inner : outer;
    outline.vertices.push_back({radius * std::cos(angle), radius * std::sin(angle)});
  }
  return outline;
}

double star_area(int points, double inner, double outer) {
  return points * inner * outer * std::sin(std::numbers::pi / points);
}

TEST(Triangulation, CoversAPolygonWhicheverWayItTurns) {
  TrimmingOutline outline = square(0, 0, 2);
  EXPECT_NEAR(area({outline}), 4, 1e-12);
  std::reverse(outline.vertices.begin(), outline.vertices.end());
  EXPECT_NEAR(area({outline}), 4, 1e-12);
  TriangulationBudget budget;
  EXPECT_EQ(triangulate({outline}, budget).size(), 2u);
}

TEST(Triangulation, CoversWhatIsNotConvex) {
  for (const int points : {3, 7, 40}) EXPECT_NEAR(area({star(points, 1, 3)}), star_area(points, 1, 3), 1e-9);
}

TEST(Triangulation, LeavesHolesOpen) {
  EXPECT_NEAR(area({square(0, 0, 10), square(2, 2, 3, true), square(6, 1, 2, true), square(5, 6, 3, true)}),
              100 - 9 - 4 - 9, 1e-9);
  TrimmingOutline hole = star(9, 0.3, 0.9);
  hole.hole = true;
  EXPECT_NEAR(area({star(9, 1, 3), hole}), star_area(9, 1, 3) - star_area(9, 0.3, 0.9), 1e-9);
}

TEST(Triangulation, TakesSeveralPolygonsEachWithItsHoles) {
  EXPECT_NEAR(area({square(0, 0, 4), square(10, 0, 4), square(11, 1, 1, true), square(1, 1, 2, true)}), 16 + 16 - 1 - 4,
              1e-9);
  EXPECT_NEAR(area({square(0, 0, 4), square(20, 20, 1, true)}), 16, 1e-12) << "a hole outside of all";
}

TEST(Triangulation, EndsForOutlinesThatAreNone) {
  EXPECT_EQ(area({}), 0);
  EXPECT_EQ(area({{false, {}}}), 0);
  EXPECT_EQ(area({{false, {{0, 0}, {1, 1}}}}), 0);
  EXPECT_EQ(area({{false, {{0, 0}, {1, 0}, {2, 0}, {1, 0}}}}), 0);  // a line there and back
  EXPECT_EQ(area({{false, std::vector<Point>(50, Point(1, 1))}}), 0);
  area({{false, {{0, 0}, {1, 1}, {1, 0}, {0, 1}}}});  // crosses itself
  TrimmingOutline tangle;
  for (int i = 0; i < 200; ++i) tangle.vertices.push_back({(i * 73) % 101, (i * 37) % 89});
  TrimmingOutline hole = tangle;
  hole.hole = true;
  area({tangle, hole});
}

/// Quarter of a cylinder's side as a B-spline of many control points: x = sin, z = -cos of the angle, y = eta.
TrimmedSurface arch() {
  BsplineSurface shape{1, clamped_knots(1, 200), clamped_knots(1, 2), {}};
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 200; ++i) {
      const double angle = std::numbers::pi / 2 * i / 199;
      shape.points.emplace_back(std::sin(angle), j, -std::cos(angle));
    }
  return {shape, {square(0, 0, 1)}, 1000, 0.001};
}

TEST(TrimmedSurface, IsSplitUntilItsEdgesAreNear) {
  for (const double tolerance : {0.1, 0.01, 0.001}) {
    TriangulationBudget budget;
    const Mesh mesh = triangulate(arch(), tolerance, budget);
    double sum = 0;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::array<int, 3> corners{a, b, c};
      for (std::size_t k = 0; k < 3; ++k) {
        const Eigen::Vector3d middle =
            (mesh.vertices[std::size_t(corners[k])] + mesh.vertices[std::size_t(corners[(k + 1) % 3])]) / 2;
        EXPECT_NEAR(std::hypot(middle.x(), middle.z()), 1, 1.1 * tolerance);
      }
      const auto& p = mesh.vertices;
      sum += (p[std::size_t(b)] - p[std::size_t(a)]).cross(p[std::size_t(c)] - p[std::size_t(a)]).norm() / 2;
    }
    EXPECT_NEAR(sum, std::numbers::pi / 2, 3 * tolerance);
  }
}

TEST(TrimmedSurface, HasNoCracks) {
  // Every edge inside belongs to two triangles; those of one only lie on the border of the domain.
  TriangulationBudget budget;
  const Mesh mesh = triangulate(arch(), 0.001, budget);
  std::map<std::pair<int, int>, int> uses;
  for (const auto& t : mesh.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++uses[std::minmax(t[k], t[(k + 1) % 3])];
  for (const auto& [edge, count] : uses) {
    EXPECT_LE(count, 2);
    if (count == 2) continue;
    const Eigen::Vector3d middle =
        (mesh.vertices[std::size_t(edge.first)] + mesh.vertices[std::size_t(edge.second)]) / 2;
    EXPECT_LT(std::min({std::abs(middle.x()), std::abs(middle.z()), middle.y(), 1 - middle.y()}), 1e-9);
  }
}

TEST(TrimmedSurface, PlanesAreNotSplit) {
  const TrimmedSurface plane{PlaneSurface{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {square(-1, -1, 2)}, 100, 0};
  TriangulationBudget budget;
  const Mesh mesh = triangulate(plane, 1e-6, budget);
  EXPECT_EQ(mesh.triangles.size(), 2u);
  EXPECT_EQ(mesh.vertices.size(), 4u);
  for (const Eigen::Vector3d& p : mesh.vertices) EXPECT_EQ(p.z(), 1);
}

// The surfaces of a file share what may be spent: twice as many small ones cost no more than one large one.
TEST(TrimmedSurface, TakesWhatItCostsFromTheBudget) {
  TriangulationBudget budget;
  const std::size_t triangles = triangulate(arch(), 0.001, budget).triangles.size();
  EXPECT_EQ(budget.triangles, TriangulationBudget::most_triangles - triangles);
  EXPECT_LT(budget.tests, TriangulationBudget::most_tests);
  const std::size_t tests = TriangulationBudget::most_tests - budget.tests;

  TriangulationBudget for_two{2 * tests, 2 * triangles};
  for (int i = 0; i < 2; ++i) EXPECT_EQ(triangulate(arch(), 0.001, for_two).triangles.size(), triangles);
  EXPECT_EQ(for_two.tests, 0u);
  EXPECT_EQ(for_two.triangles, 0u);
  EXPECT_THROW(triangulate(arch(), 0.001, for_two), InputError);
  TriangulationBudget too_few{tests, triangles - 1};
  EXPECT_THROW(triangulate(arch(), 0.001, too_few), InputError);
}

// Holes are joined to the polygon around them one after the other.
TEST(Triangulation, CountsTheTestsOfHoles) {
  const auto tests = [](int holes) {
    std::vector<TrimmingOutline> outlines{square(0, 0, 100)};
    for (int i = 0; i < holes; ++i) outlines.push_back(square(1 + 3 * (i % 30), 1 + 3 * (i / 30), 1, true));
    TriangulationBudget budget;
    triangulate(outlines, budget);
    return double(TriangulationBudget::most_tests - budget.tests);
  };
  EXPECT_GT(tests(200), 3 * tests(100));  // by the square: what bounds it is the budget
  TriangulationBudget little{50, 1000};
  EXPECT_THROW(
      triangulate({square(0, 0, 9), square(1, 1, 1, true), square(3, 3, 1, true), square(5, 5, 1, true)}, little),
      InputError);
}

TEST(TrimmedSurface, CountsItsBytes) {
  const TrimmedSurface plane{PlaneSurface{{0, 0, 1}, {1, 0, 0}, {0, 1, 0}}, {square(-1, -1, 2)}, 100, 0};
  EXPECT_EQ(plane.bytes(), 4u * (9 + 1 + 8));
  BsplineSurface shape{2, clamped_knots(2, 3), clamped_knots(2, 3), std::vector<Eigen::Vector3d>(9)};
  EXPECT_EQ((TrimmedSurface{shape, {}, 100, 0}.bytes()), 4u * (1 + 12 + 27));
}

}  // namespace
}  // namespace gestalt
