// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/boundary_lines.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <numbers>

#include "gestalt/core/pipeline/surface_modelling.h"
#include "gestalt/core/scene/scene.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f facing(0, 0, -1);

BoundaryLines lines_of(const test::KnownScene& known) {
  return find_boundary_lines(known.frame, known.surfaces, find_contours(known.surfaces));
}

std::vector<BoundaryLine> lines_of_surface(const BoundaryLines& all, int surface) {
  std::vector<BoundaryLine> lines;
  std::copy_if(all.lines.begin(), all.lines.end(), std::back_inserter(lines),
               [&](const BoundaryLine& line) { return line.surface == surface; });
  return lines;
}

Eigen::Vector2f left_of(const BoundaryLine& line) { return {line.direction.y(), -line.direction.x()}; }

test::KnownScene rectangle(const cv::Rect& pixels) { return test::render({{pixels, {0, 0, 1}, facing}}); }

TEST(BoundaryLines, OfARectangleAreItsFourSidesAroundIt) {
  const BoundaryLines all = lines_of(rectangle({200, 150, 101, 61}));
  ASSERT_EQ(all.lines.size(), 4u);
  const Eigen::Vector2f centre(250, 180);
  for (const std::size_t i : {0, 1}) EXPECT_NEAR(all.lines[i].length, 100, 0.1);
  for (const std::size_t i : {2, 3}) EXPECT_NEAR(all.lines[i].length, 60, 0.1);
  for (const BoundaryLine& line : all.lines) {
    EXPECT_GT(left_of(line).dot(centre - line.ends[0]), 0) << "the surface is on the left";
    EXPECT_EQ(line.beyond, Beyond::nothing);
    EXPECT_TRUE(line.own());
    // 1 m away a pixel is 1 / 525 m wide.
    EXPECT_NEAR((line.points[1] - line.points[0]).norm(), line.length / 525, 1e-4);
    EXPECT_NEAR(line.points[0].x(), (line.ends[0].x() - 319.5f) / 525, 1e-4);
    EXPECT_NEAR(line.points[0].z(), 1, 1e-4);
  }
}

TEST(BoundaryLines, OfARectangleMeetInFourCorners) {
  const BoundaryLines all = lines_of(rectangle({200, 150, 101, 61}));
  EXPECT_TRUE(all.collinearities.empty());
  ASSERT_EQ(all.junctions.size(), 4u);
  for (const LineLink& corner : all.junctions) {
    EXPECT_NEAR(corner.turn, std::numbers::pi / 2, 1e-3) << "to the left";
    EXPECT_LT(corner.gap, 1);
    EXPECT_NEAR(std::abs(corner.meeting.x() - 250), 50, 0.6);
    EXPECT_NEAR(std::abs(corner.meeting.y() - 180), 30, 0.6);
  }
}

TEST(BoundaryLines, GoAlongASlantedEdge) {
  test::KnownScene known = rectangle({0, 0, 300, 300});
  // What is left of the square below a line of slope 1 / 3.
  SurfaceSet& set = known.surfaces;
  std::erase_if(set.surfaces[0].pixels, [](int pixel) { return pixel / 640 < 100 + (pixel % 640) / 3; });
  set.labels = 0;
  for (const int pixel : set.surfaces[0].pixels) set.labels(pixel / 640, pixel % 640) = 1;
  const BoundaryLines all = lines_of(known);
  const double slope = std::atan2(1.0, 3.0);
  const auto slanted = std::find_if(all.lines.begin(), all.lines.end(), [&](const BoundaryLine& line) {
    return std::abs(std::atan2(-line.direction.y(), -line.direction.x()) - slope) < 0.01;
  });
  ASSERT_NE(slanted, all.lines.end()) << "it runs from right to left, the surface below it";
  EXPECT_NEAR(slanted->length, 300 / std::cos(slope), 4);
}

TEST(BoundaryLines, OfAHoleRunAroundItTheOtherWay) {
  test::KnownScene known =
      test::render({{{100, 100, 200, 200}, {0, 0, 1}, facing}, {{170, 170, 60, 60}, {0, 0, 1.2f}, facing}});
  const auto lines = lines_of_surface(lines_of(known), 0);
  ASSERT_EQ(lines.size(), 8u);
  int around_hole = 0;
  for (const BoundaryLine& line : lines)
    if (line.length < 100) {
      ++around_hole;
      EXPECT_LT(left_of(line).dot(Eigen::Vector2f(200, 200) - line.ends[0]), 0) << "the hole is on the right";
      EXPECT_EQ(line.beyond, Beyond::farther);
    }
  EXPECT_EQ(around_hole, 4);
}

TEST(BoundaryLines, AtAnOcclusionBelongToTheNearerSurface) {
  const BoundaryLines all = lines_of(test::rectangle_before_wall());
  for (const BoundaryLine& line : lines_of_surface(all, 1)) EXPECT_EQ(line.beyond, Beyond::farther);
  const auto wall = lines_of_surface(all, 0);
  EXPECT_EQ(std::count_if(wall.begin(), wall.end(), [](const auto& line) { return line.beyond == Beyond::nearer; }), 4);
  EXPECT_EQ(std::count_if(wall.begin(), wall.end(), [](const auto& line) { return line.own(); }), 4) << "its outside";
  for (const auto* links : {&all.junctions, &all.collinearities})
    for (const LineLink& link : *links)
      EXPECT_TRUE(all.lines[std::size_t(link.from)].own() && all.lines[std::size_t(link.to)].own());
}

TEST(BoundaryLines, AreSeenAcrossTheShadowOfASensor) {
  test::KnownScene known = test::rectangle_before_wall();
  // No depth left of the rectangle for 12 px: the wall's contour there ends at the shadow.
  for (int v = 180; v < 300; ++v)
    for (int u = 248; u < 260; ++u) {
      known.frame.depth(v, u) = 0;
      known.surfaces.labels(v, u) = 0;
    }
  std::erase_if(known.surfaces.surfaces[0].pixels,
                [&](int pixel) { return known.frame.depth.ptr<float>()[pixel] == 0; });
  for (const BoundaryLine& line : lines_of_surface(lines_of(known), 1)) EXPECT_EQ(line.beyond, Beyond::farther);
  const auto wall = lines_of_surface(lines_of(known), 0);
  EXPECT_EQ(std::count_if(wall.begin(), wall.end(), [](const auto& line) { return line.beyond == Beyond::nearer; }), 4);
}

TEST(BoundaryLines, AtTheImageEdgeAreNoEndOfTheSurface) {
  const BoundaryLines all = lines_of(rectangle({0, 0, 100, 480}));
  ASSERT_EQ(all.lines.size(), 4u);
  EXPECT_EQ(std::count_if(all.lines.begin(), all.lines.end(), [](const auto& line) { return line.own(); }), 1);
}

TEST(BoundaryLines, OfOneRowRunThereAndBack) {
  const BoundaryLines all = lines_of(rectangle({100, 200, 50, 1}));
  ASSERT_EQ(all.lines.size(), 2u);
  EXPECT_NEAR(all.lines[0].direction.dot(all.lines[1].direction), -1, 1e-6);
}

TEST(BoundaryLines, OfSpecksAreNone) {
  EXPECT_TRUE(lines_of(rectangle({100, 200, 1, 1})).lines.empty());
  EXPECT_TRUE(lines_of(rectangle({100, 200, 5, 5})).lines.empty());
}

TEST(BoundaryLines, GoOnBehindAnOccluder) {
  const BoundaryLines all = lines_of(test::render({{{100, 200, 200, 80}, {0, 0, 1}, facing},
                                                   {{340, 200, 200, 80}, {0, 0, 1}, facing},
                                                   {{300, 150, 40, 180}, {0, 0, 0.8f}, facing}}));
  int between = 0;
  for (const LineLink& link : all.collinearities) {
    const BoundaryLine &from = all.lines[std::size_t(link.from)], &to = all.lines[std::size_t(link.to)];
    if (from.surface == 2 || to.surface == 2) continue;
    ++between;
    EXPECT_NE(from.surface, to.surface);
    EXPECT_NEAR(link.gap, 41, 0.5);
    EXPECT_NEAR(link.turn, 0, 1e-3);
  }
  EXPECT_EQ(between, 2) << "above from right to left, below from left to right, and not the other way";
}

TEST(BoundaryLines, OfBothSidesInLineAreNotOneBoundary) {
  // The upper edge of one is in line with the lower edge of the other.
  const BoundaryLines all =
      lines_of(test::render({{{100, 200, 200, 80}, {0, 0, 1}, facing}, {{340, 120, 200, 80}, {0, 0, 1}, facing}}));
  EXPECT_TRUE(all.collinearities.empty());
}

TEST(BoundaryLines, AreCutWhereAnotherEndsOnThem) {
  // Two faces on top of a wide one; the seam between them ends in the middle of its upper edge.
  const auto scene = [](float depth) {
    return test::render({{{200, 240, 200, 60}, {0, 0, 1}, facing},
                         {{200, 140, 90, 100}, {0, 0, depth}, facing},
                         {{290, 140, 110, 100}, {0, 0, depth}, facing}});
  };
  const BoundaryLines together = lines_of(scene(1));
  EXPECT_EQ(together.t_junctions.size(), 1u);
  EXPECT_NEAR(together.t_junctions.at(0).at.x(), 289.5, 1.5);
  EXPECT_EQ(lines_of_surface(together, 0).size(), 5u);
  EXPECT_TRUE(lines_of(scene(1.3f)).t_junctions.empty()) << "the seam ends behind the edge, not on it";
}

TEST(BoundaryLines, AreTheSameInAnotherResolution) {
  const auto scene = [](int width, int height) {
    const int s = width / 320;
    return test::render({{{50 * s, 60 * s, 90 * s, 40 * s}, {0, 0, 1}, {0.3f, 0.2f, -1}},
                         {{160 * s, 60 * s, 90 * s, 40 * s}, {0, 0, 1}, {0.3f, 0.2f, -1}}},
                        test::kinect(width, height));
  };
  const BoundaryLines coarse = lines_of(scene(320, 240)), fine = lines_of(scene(1280, 960));
  EXPECT_EQ(fine.lines.size(), 8u);
  EXPECT_GE(fine.junctions.size(), 8u) << "the corners";
  EXPECT_EQ(fine.collinearities.size(), 2u) << "above and below";
  ASSERT_EQ(coarse.lines.size(), fine.lines.size());
  EXPECT_EQ(coarse.junctions.size(), fine.junctions.size());
  EXPECT_EQ(coarse.collinearities.size(), fine.collinearities.size());
}

TEST(BoundaryLines, AreTheSameForAnyNumberOfThreadsAndOfThousandsBounded) {
  std::vector<test::PlanarPatch> patches;
  for (int row = 0; row < 21; ++row)
    for (int column = 0; column < 26; ++column)
      patches.push_back(
          {{column * 24 + 5, row * 22 + 5, 20 - row % 2, 18}, {0, 0, 1 + 0.1f * float((row + column) % 7)}, facing});
  const test::KnownScene known = test::render(patches);
  ASSERT_EQ(known.surfaces.surfaces.size(), 546u);
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    return lines_of(known);
  };
  const auto expect_same = [](const std::vector<LineLink>& one, const std::vector<LineLink>& other) {
    ASSERT_FALSE(one.empty());
    ASSERT_EQ(one.size(), other.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].from, other[i].from);
      EXPECT_EQ(one[i].to, other[i].to);
      EXPECT_EQ(one[i].cost, other[i].cost);
    }
  };
  const BoundaryLines all = with_threads(1), again = with_threads(4);
  EXPECT_EQ(all.lines.size(), 1500u);
  EXPECT_LE(all.junctions.size() + all.collinearities.size(), 12 * all.lines.size());
  expect_same(all.junctions, again.junctions);
  expect_same(all.collinearities, again.collinearities);
}

}  // namespace
}  // namespace gestalt
