// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <random>

#include "bspline.h"
#include "gestalt/core/pipeline/surface_modelling.h"
#include "gestalt/tests/scenes/test_scenes.h"
#include "normals.h"
#include "plane.h"

namespace gestalt {
namespace {

using Fitters = std::vector<std::shared_ptr<const Fitter>>;

Fitters planes() { return {std::make_shared<Plane>(Plane::Params{})}; }
Fitters planes_and_bsplines() {
  return {std::make_shared<Plane>(Plane::Params{}), std::make_shared<Bspline>(Bspline::Params{})};
}

/// Something seen by the Kinect: its depth with noise, and which part of it each pixel shows (0 = none).
struct View {
  Frame frame;
  cv::Mat_<int> parts;
};

/// depth(u, v) gives the depth of a pixel and its part.
template <class Depth>
View view(const Camera& camera, const Depth& depth, unsigned noise_seed = 1) {
  std::mt19937 generator(noise_seed);
  std::normal_distribution<float> normal(0, 1);
  cv::Mat_<float> image(camera.height, camera.width, 0.f);
  cv::Mat_<int> parts(image.size(), 0);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const auto [z, part] = depth((u - camera.cx) / camera.fx, (v - camera.cy) / camera.fy);
      if (!(z > 0)) continue;
      image(v, u) = float(z) + 0.5f * float(DepthNoise{}.at(z)) * normal(generator);
      parts(v, u) = part;
    }
  return {make_frame("view", {}, image, camera), parts};
}

/// The wall of a mug of 4 cm radius and 10 cm height, 0.8 m away, with nothing around it: x, y are those of a ray at
/// z = 1.
View mug(unsigned noise_seed = 1) {
  const auto wall = [](double x, double y) {
    constexpr double radius = 0.04, distance = 0.84;
    const double a = x * x + 1, b = -distance, c = distance * distance - radius * radius, d = b * b - a * c;
    if (d <= 0) return std::pair(0.0, 0);
    const double z = (-b - std::sqrt(d)) / a;
    return std::abs(y * z) < 0.05 ? std::pair(z, 1) : std::pair(0.0, 0);
  };
  return view(test::kinect(), wall, noise_seed);
}

/// Surface with most pixels of a part, and its share of them.
std::pair<int, double> largest_surface(const SurfaceSet& set, const cv::Mat_<int>& parts, int part) {
  std::map<int, int> pixels;
  int all = 0;
  for (int i = 0; i < int(parts.total()); ++i) {
    if (parts(i) != part) continue;
    ++all;
    if (set.labels(i) > 0) ++pixels[set.labels(i)];
  }
  std::pair<int, int> most{0, 0};
  for (const auto& entry : pixels)
    if (entry.second > most.second) most = entry;
  return {most.first, double(most.second) / all};
}

SurfaceSet surfaces_of(const View& seen, const Fitters& fitters) {
  return model_surfaces(seen.frame, Normals({}).cluster(seen.frame), fitters, {});
}

// A mug's wall costs about as much in two planes as in one B-spline: which it is hangs on the noise.
TEST(Surfaces, TheWallOfAMugCanBeOneBspline) {
  int in_one = 0;
  for (unsigned noise_seed = 1; noise_seed <= 12; ++noise_seed) {
    const View seen = mug(noise_seed);
    EXPECT_LT(largest_surface(surfaces_of(seen, planes()), seen.parts, 1).second, 0.75) << "planes do as well";
    const SurfaceSet set = surfaces_of(seen, planes_and_bsplines());
    const auto [surface, share] = largest_surface(set, seen.parts, 1);
    ASSERT_GT(surface, 0);
    if (share < 0.9) continue;
    ++in_one;
    EXPECT_EQ(set.surfaces[std::size_t(surface - 1)].model->type(), "bspline");
  }
  EXPECT_GE(in_one, 3);
}

/// Two boxes that touch stay two, and either is one surface.
void expect_two(const View& seen) {
  const SurfaceSet set = surfaces_of(seen, planes_and_bsplines());
  const auto [left, share_of_left] = largest_surface(set, seen.parts, 1);
  const auto [right, share_of_right] = largest_surface(set, seen.parts, 2);
  EXPECT_NE(left, right);
  EXPECT_GT(share_of_left, 0.95);
  EXPECT_GT(share_of_right, 0.95);
}

TEST(Surfaces, BoxesWithFacesInAStepStayTwo) {
  for (const double step : {0.012, 0.02})
    expect_two(view(test::kinect(), [step](double x, double y) {
      if (std::abs(y) > 0.1 || std::abs(x) > 0.15) return std::pair(0.0, 0);
      return x < 0 ? std::pair(0.8, 1) : std::pair(0.8 + step, 2);
    }));
}

TEST(Surfaces, BoxesThatMeetInACornerStayTwo) {
  // Faces turned by 30 and by 45 degrees to the view, towards each other.
  for (const double slope : {0.58, 1.0})
    expect_two(view(test::kinect(), [slope](double x, double y) {
      if (std::abs(y) > 0.1 || std::abs(x) > 0.15) return std::pair(0.0, 0);
      return x < 0 ? std::pair(0.8 / (1 - slope * x), 1) : std::pair(0.8 / (1 + slope * x), 2);
    }));
}

TEST(Surfaces, ABoxOnATableStaysApart) {
  // The table falls away by 45 degrees; the box's face stands on it.
  const View seen = view(test::kinect(), [](double x, double y) {
    const double table = 1 / (1 + y);
    const bool box = std::abs(x) < 0.06 && y > -0.15 && y < 0.05 && 0.95 < table;
    return box ? std::pair(0.95, 2) : std::pair(table, 1);
  });
  const SurfaceSet set = surfaces_of(seen, planes_and_bsplines());
  EXPECT_NE(largest_surface(set, seen.parts, 1).first, largest_surface(set, seen.parts, 2).first);
  EXPECT_GT(largest_surface(set, seen.parts, 2).second, 0.9);
}

TEST(Surfaces, AreTheSameForAnyNumberOfThreads) {
  const View seen = mug();
  const auto run = [&](int threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
    const SurfaceSet set = surfaces_of(seen, planes_and_bsplines());
    nlohmann::json json;
    for (const Surface& surface : set.surfaces) json.push_back(surface.model->to_json());
    return std::pair(json, set.labels);
  };
  const auto [json, labels] = run(1);
  for (const int threads : {2, 8}) {
    const auto [other_json, other_labels] = run(threads);
    EXPECT_EQ(other_json, json);
    EXPECT_TRUE(std::equal(labels.begin(), labels.end(), other_labels.begin()));
  }
}

TEST(Surfaces, TellWhyAPatchHasNoBspline) {
  test::KnownScene line = test::render({{{100, 100, 60, 1}, {0, 0, 1}, {0, 0, -1}}});
  const SurfaceSet set = model_surfaces(line.frame, line.patches, planes_and_bsplines(), {});
  ASSERT_EQ(set.surfaces.size(), 1u);
  EXPECT_EQ(set.surfaces[0].model->type(), "plane");
  EXPECT_EQ(set.surfaces[0].refusals, (std::vector<std::string>{"", "collinear points"}));
}

}  // namespace
}  // namespace gestalt
