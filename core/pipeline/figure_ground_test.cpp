// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/pipeline/figure_ground.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <opencv2/core.hpp>

#include "gestalt/core/pipeline/surface_modelling.h"
#include "gestalt/core/scene/segmentation.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

using Eigen::Vector3d;

/// A rectangle in space, {corner + a s + b t : s, t in [0, 1]}.
struct Rectangle {
  Vector3d corner, a, b;
};

/// World: x right, y away from the camera, z up; metres.
struct World {
  std::vector<Rectangle> rectangles;

  /// Returns the index of the rectangle.
  int add(const Vector3d& corner, const Vector3d& a, const Vector3d& b) {
    rectangles.push_back({corner, a, b});
    return int(rectangles.size()) - 1;
  }

  /// The three faces of a box that a camera in front of and above it can see: front, top and the side nearer to x = 0.
  std::vector<int> add_box(const Vector3d& corner, const Vector3d& size) {
    const Vector3d x(size.x(), 0, 0), y(0, size.y(), 0), z(0, 0, size.z());
    const Vector3d side = corner.x() > 0 ? corner : Vector3d(corner + x);
    return {add(corner, x, z), add(corner + z, x, y), add(side, y, z)};
  }
};

/// A camera 1 m in front of the origin and 0.8 m above it, that looks at a point 0.1 m beyond the origin; rolled by an
/// angle around its axis. Sees what World holds without noise; each rectangle is a surface.
struct View {
  SurfaceSet surfaces;
  Frame frame;
  std::vector<int> surface_of;  // rectangle; -1 when it is not seen

  explicit View(const World& world, double roll = 0, int width = 320, int height = 240) {
    const Vector3d eye(0, -1, 0.8), forward = (Vector3d(0, 0.1, 0) - eye).normalized();
    const Vector3d right0 = Vector3d::UnitX(), down0 = forward.cross(right0);
    const Vector3d right = std::cos(roll) * right0 + std::sin(roll) * down0;
    const Vector3d down = forward.cross(right);
    const Camera camera = test::kinect(width, height);
    cv::Mat_<float> depth(height, width, 0.f);
    cv::Mat_<int> source(height, width, -1);
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) {
        const Vector3d ray = forward + (u - camera.cx) / camera.fx * right + (v - camera.cy) / camera.fy * down;
        for (std::size_t i = 0; i < world.rectangles.size(); ++i) {
          const auto& [corner, a, b] = world.rectangles[i];
          const Vector3d normal = a.cross(b);
          const double slant = normal.dot(ray);
          if (std::abs(slant) < 1e-12) continue;
          const double z = normal.dot(corner - eye) / slant;
          const Vector3d in = eye + z * ray - corner;
          const double s = in.dot(a) / a.squaredNorm(), t = in.dot(b) / b.squaredNorm();
          if (z <= 0 || s < 0 || s > 1 || t < 0 || t > 1 || (depth(v, u) > 0 && float(z) >= depth(v, u))) continue;
          depth(v, u) = float(z);
          source(v, u) = int(i);
        }
      }
    frame = make_frame("view", {}, depth, camera);
    surfaces.labels = cv::Mat_<int>(height, width, 0);
    for (std::size_t i = 0; i < world.rectangles.size(); ++i) {
      Surface surface;
      for (int pixel = 0; pixel < int(source.total()); ++pixel)
        if (source(pixel) == int(i)) surface.pixels.push_back(pixel);
      surface_of.push_back(surface.pixels.empty() ? -1 : int(surfaces.surfaces.size()));
      if (surface.pixels.empty()) continue;
      surfaces.surfaces.push_back(std::move(surface));
      for (const int pixel : surfaces.surfaces.back().pixels) surfaces.labels(pixel) = int(surfaces.surfaces.size());
    }
    surfaces.adjacencies = find_adjacencies(frame, surfaces.labels, {});
  }

  /// Expects the background to be these rectangles, as far as they are seen, and all else objects.
  void expect_background(const std::vector<int>& rectangles, const FigureGroundParams& params = {}) const {
    const std::vector<Role> roles = find_roles(frame, surfaces, params);
    ASSERT_EQ(roles.size(), surfaces.surfaces.size());
    for (int i = 0; i < int(surface_of.size()); ++i) {
      if (surface_of[std::size_t(i)] < 0) continue;
      const bool background = std::find(rectangles.begin(), rectangles.end(), i) != rectangles.end();
      EXPECT_EQ(name_of(roles[std::size_t(surface_of[std::size_t(i)])]), background ? "background" : "object")
          << "rectangle " << i;
    }
  }
};

int add_table(World& world) { return world.add({-0.5, -0.4, 0}, {1, 0, 0}, {0, 1, 0}); }

TEST(FigureGround, ATableIsBackgroundAndBoxesAreObjects) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.25, 0, 0}, {0.15, 0.1, 0.2});
  world.add_box({0.1, 0.1, 0}, {0.2, 0.15, 0.1});
  View(world).expect_background({table});
}

TEST(FigureGround, DoesNotDependOnTheRollOfTheCamera) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.25, 0, 0}, {0.15, 0.1, 0.2});
  for (const double roll : {CV_PI / 2, CV_PI, -CV_PI / 2, 0.6}) View(world, roll).expect_background({table});
}

TEST(FigureGround, DoesNotDependOnTheResolution) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.25, 0, 0}, {0.15, 0.1, 0.2});
  View(world, 0, 640, 480).expect_background({table});
  View(world, 0, 80, 60).expect_background({table});
}

TEST(FigureGround, TwoPartsOfATableAreBackground) {
  World world;
  const int left = world.add({-0.5, -0.4, 0}, {0.45, 0, 0}, {0, 1, 0});
  const int right = world.add({0.05, -0.4, 0}, {0.45, 0, 0}, {0, 1, 0});
  world.add_box({-0.05, -0.4, 0}, {0.1, 0.9, 0.1});
  View(world).expect_background({left, right});
}

TEST(FigureGround, WallAndFloorAreBackground) {
  World world;
  const int floor = world.add({-2, -1, 0}, {4, 0, 0}, {0, 1.6, 0});
  const int wall = world.add({-2, 0.6, 0}, {4, 0, 0}, {0, 0, 2});
  world.add_box({-0.1, 0, 0}, {0.2, 0.15, 0.2});
  View(world).expect_background({floor, wall});
}

TEST(FigureGround, WhatIsSeenBeyondATableIsBackground) {
  World world;
  const int floor = world.add({-3, -3, -0.7}, {6, 0, 0}, {0, 8, 0});
  const int table = add_table(world);
  world.add_box({-0.1, 0, 0}, {0.2, 0.15, 0.2});
  View(world).expect_background({floor, table});
}

TEST(FigureGround, ABoxThatCarriesAnotherIsAnObject) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.2, 0, 0}, {0.4, 0.3, 0.1});
  world.add_box({-0.1, 0.1, 0.1}, {0.2, 0.1, 0.1});
  View(world).expect_background({table});
}

TEST(FigureGround, AThinBoxOnATableIsAnObject) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.1, 0, 0}, {0.2, 0.15, 0.02});
  View(world).expect_background({table});
}

TEST(FigureGround, ALonePlaneIsBackground) {
  World world;
  const int table = add_table(world);
  View(world).expect_background({table});
}

TEST(FigureGround, AFrameFullOfOneBoxIsAnObject) {
  World world;
  world.add_box({-0.2, 0, -0.1}, {0.4, 0.3, 0.3});
  View(world).expect_background({});
}

TEST(FigureGround, OnlyWhatIsOnTheTableOfARoomIsAnObject) {
  World world;
  std::vector<int> background{world.add({-3, -3, -0.7}, {6, 0, 0}, {0, 5.5, 0}),  // floor
                              world.add({-3, 2.5, -0.7}, {6, 0, 0}, {0, 0, 3}),   // wall
                              add_table(world)};
  world.add_box({-0.1, 0, 0}, {0.2, 0.15, 0.2});
  const auto add_background = [&](const Vector3d& corner, const Vector3d& size) {
    for (const int face : world.add_box(corner, size)) background.push_back(face);
  };
  add_background({-0.48, -0.38, -0.7}, {0.06, 0.06, 0.7});  // legs
  add_background({0.42, -0.38, -0.7}, {0.06, 0.06, 0.7});
  add_background({0.9, 1.2, -0.7}, {0.4, 0.4, 0.5});      // on the floor
  add_background({-0.2, 1.7, -0.2}, {0.05, 0.05, 0.05});  // in the air beyond the table
  View(world).expect_background(background);
  View(world, CV_PI / 2).expect_background(background);
}

TEST(FigureGround, WallsOfABinAreBackground) {
  World world;
  const Vector3d x(0.6, 0, 0), y(0, 0.5, 0), z(0, 0, 0.15);
  const std::vector<int> background{world.add({-2, -2, -0.6}, {4, 0, 0}, {0, 5, 0}),
                                    world.add({-0.3, -0.2, 0}, x, y),  // bottom
                                    world.add({-0.3, -0.2, 0}, x, z),
                                    world.add({-0.3, 0.3, 0}, x, z),
                                    world.add({-0.3, -0.2, 0}, y, z),
                                    world.add({0.3, -0.2, 0}, y, z)};
  world.add_box({-0.1, 0.05, 0}, {0.12, 0.08, 0.06});
  world.add_box({0.1, 0.12, 0}, {0.08, 0.08, 0.1});
  View(world).expect_background(background);
}

TEST(FigureGround, ABoxAsWideAsTheTableIsAnObject) {
  World world;
  const int table = add_table(world);
  world.add_box({-0.48, 0.3, 0}, {0.96, 0.25, 0.25});
  world.add_box({0.1, 0, 0}, {0.1, 0.1, 0.1});
  View(world).expect_background({table});
}

TEST(FigureGround, ASmallDentOfATableIsBackgroundAndAMagazineIsAnObject) {
  FigureGroundParams params;
  params.tolerance = 1;  // 2.4 mm at 1.2 m
  World world;
  const int table = add_table(world);
  const int dent = world.add({-0.2, 0, 0.004}, {0.03, 0, 0}, {0, 0.03, 0});
  world.add({0.05, 0, 0.004}, {0.2, 0, 0}, {0, 0.28, 0});
  View(world, 0, 640, 480).expect_background({table, dent}, params);
}

TEST(FigureGround, WhatIsBeyondMaxDepthIsBackground) {
  World world;
  const int table = add_table(world);
  const std::vector<int> box = world.add_box({-0.2, 0, 0}, {0.15, 0.1, 0.2});
  const std::vector<int> farther = world.add_box({0.1, 0.4, 0}, {0.15, 0.1, 0.2});
  std::vector<int> background{table};
  background.insert(background.end(), farther.begin(), farther.end());
  FigureGroundParams params;
  params.max_depth = 1.35;
  View(world).expect_background(background, params);
  params.max_depth = 0.1;
  background.insert(background.end(), box.begin(), box.end());
  View(world).expect_background(background, params);
}

TEST(FigureGround, WithoutAPlaneAllIsAnObject) {
  World world;
  add_table(world);
  world.add_box({-0.2, 0, 0}, {0.4, 0.3, 0.3});
  const View view(world);
  SurfaceSet one;
  one.labels = cv::Mat_<int>(view.frame.depth.size(), 0);
  Surface all;
  for (const Surface& surface : view.surfaces.surfaces)
    all.pixels.insert(all.pixels.end(), surface.pixels.begin(), surface.pixels.end());
  std::sort(all.pixels.begin(), all.pixels.end());
  one.surfaces.push_back(all);
  EXPECT_EQ(find_roles(view.frame, one, {}), std::vector<Role>{Role::object});
}

TEST(FigureGround, SizesAreAreasInUnitsOfTheLeastThatAnObjectShows) {
  const int width = 64, height = 48;
  const Camera camera = test::kinect(width, height);
  Frame frame = make_frame("wall", {}, cv::Mat_<float>(height, width, 2.F), camera);
  SurfaceSet surfaces;
  for (const int count : {1, 100}) {
    Surface surface;
    for (int p = 0; p < count; ++p) surface.pixels.push_back(p);
    surfaces.surfaces.push_back(surface);
  }
  const double pixel = 4 / (camera.fx * camera.fy);
  FigureGroundParams params;
  params.min_object = 3;
  params.least_extent = 0;
  std::vector<double> sizes = find_sizes(frame, surfaces, params);
  ASSERT_EQ(sizes.size(), 2u);
  EXPECT_NEAR(sizes[0], pixel / 3e-4, 1e-9);
  EXPECT_NEAR(sizes[1], 100 * pixel / 3e-4, 1e-9);
  params.least_extent = 10;
  frame.noise = {0.01, 0, 0};
  EXPECT_NEAR(find_sizes(frame, surfaces, params)[1], 100 * pixel / 0.01, 1e-9);
  params.min_object = params.least_extent = 0;
  EXPECT_TRUE(std::isfinite(find_sizes(frame, surfaces, params)[1]));
  EXPECT_GE(find_sizes(frame, surfaces, params)[0], 1);
  EXPECT_TRUE(find_sizes(frame, {}, params).empty());
}

TEST(FigureGround, TakesDegenerateSurfaces) {
  World world;
  add_table(world);
  const View view(world);
  EXPECT_TRUE(find_roles(view.frame, {}, {}).empty());
  for (const std::vector<int>& pixels : {std::vector<int>{160 * 320 + 160}, {160 * 320 + 160, 160 * 320 + 161}}) {
    SurfaceSet few;
    few.labels = cv::Mat_<int>(view.frame.depth.size(), 0);
    for (const int pixel : pixels) few.labels(pixel) = 1;
    few.surfaces.push_back({pixels, nullptr});
    EXPECT_EQ(find_roles(view.frame, few, {}).size(), 1u);
  }
}

TEST(FigureGround, ObjectLabelsKeepTheirNumbers) {
  Segmentation segmentation;
  segmentation.labels = (cv::Mat_<std::uint16_t>(1, 5) << 0, 1, 2, 3, 2);
  segmentation.segments.resize(3);
  segmentation.segments[1].role = Role::background;
  EXPECT_EQ(cv::countNonZero(object_labels(segmentation) != (cv::Mat_<std::uint16_t>(1, 5) << 0, 1, 0, 3, 0)), 0);
}

}  // namespace
}  // namespace gestalt
