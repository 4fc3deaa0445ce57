// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gabor.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <complex>
#include <numbers>
#include <opencv2/imgproc.hpp>
#include <random>

#include "gestalt/core/base/error.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

constexpr double pi = std::numbers::pi;
const Eigen::Vector3f before{0, 0, 1}, facing{0, 0, -1};

cv::Mat random_grey(cv::Size size, unsigned seed) {
  std::mt19937 random(seed);
  cv::Mat grey(size, CV_8UC1);
  for (int i = 0; i < int(grey.total()); ++i) grey.ptr()[i] = uchar(random() % 256);
  return grey;
}

/// Wave of unit contrast 100 about grey 128.
void draw_grating(cv::Mat& colour, const cv::Rect& where, double wavelength, double degrees) {
  const double k = 2 * pi / wavelength, c = std::cos(degrees * pi / 180), s = std::sin(degrees * pi / 180);
  for (int v = where.y; v < where.y + where.height; ++v)
    for (int u = where.x; u < where.x + where.width; ++u)
      colour.at<cv::Vec3b>(v, u) = cv::Vec3b::all(cv::saturate_cast<uchar>(128 + 100 * std::cos(k * (c * u + s * v))));
}

/// Surfaces of the given rectangles.
SurfaceSet surfaces_of(cv::Size size, const std::vector<cv::Rect>& rectangles) {
  SurfaceSet set;
  set.labels = cv::Mat_<int>(size, 0);
  for (const cv::Rect& r : rectangles) {
    set.surfaces.push_back({{}, nullptr});
    set.labels(r).setTo(int(set.surfaces.size()));
    for (int v = r.y; v < r.y + r.height; ++v)
      for (int u = r.x; u < r.x + r.width; ++u) set.surfaces.back().pixels.push_back(v * size.width + u);
  }
  return set;
}

/// The definition: magnitude of the complex Morlet kernel's sum over the mirrored image around one pixel.
double defined_magnitude(const GaborBank& bank, const cv::Mat& grey, int u, int v, int scale, int direction) {
  const double k = bank.wave_number(scale), deviation = bank.deviation(scale), theta = pi * direction / bank.directions;
  const int radius = bank.radius(scale);
  std::complex<double> wave_sum = 0, image_wave = 0;
  double gauss_sum = 0, image_gauss = 0;
  for (int dy = -radius; dy <= radius; ++dy)
    for (int dx = -radius; dx <= radius; ++dx) {
      const double gauss = std::exp(-0.5 * (dx * dx + dy * dy) / (deviation * deviation));
      const auto wave = gauss * std::polar(1.0, k * (std::cos(theta) * dx + std::sin(theta) * dy));
      const double value = grey.at<uchar>(cv::borderInterpolate(v + dy, grey.rows, cv::BORDER_REFLECT_101),
                                          cv::borderInterpolate(u + dx, grey.cols, cv::BORDER_REFLECT_101));
      wave_sum += wave;
      gauss_sum += gauss;
      image_wave += wave * value;
      image_gauss += gauss * value;
    }
  return std::abs(image_wave - wave_sum / gauss_sum * image_gauss) / gauss_sum;
}

std::vector<GaborDescriptor> describe(const GaborBank& bank, const cv::Mat& grey, const SurfaceSet& surfaces) {
  const cv::Mat everywhere(grey.size(), CV_8UC1, cv::Scalar(1));
  return describe(bank, GaborResponses(bank, grey, grid_box(everywhere, bank.stride)), surfaces);
}

/// Largest difference of describe() from the definition over some single pixels.
void expect_defined_magnitudes(const GaborBank& bank, cv::Size size, const std::vector<cv::Point>& at) {
  const cv::Mat grey = random_grey(size, 7);
  std::vector<cv::Rect> rectangles;
  for (const cv::Point& p : at) rectangles.emplace_back(p, cv::Size(1, 1));
  const auto descriptors = describe(bank, grey, surfaces_of(size, rectangles));
  ASSERT_EQ(descriptors.size(), at.size());
  for (std::size_t i = 0; i < at.size(); ++i)
    for (int scale = 0; scale < bank.scales; ++scale)
      for (int j = 0; j < bank.directions; ++j) {
        const auto f = std::size_t(scale * bank.directions + j);
        const cv::Point grid(at[i].x / bank.stride * bank.stride, at[i].y / bank.stride * bank.stride);
        EXPECT_NEAR(descriptors[i].mean[f], defined_magnitude(bank, grey, grid.x, grid.y, scale, j), 0.02)
            << at[i] << " scale " << scale << " direction " << j;
        EXPECT_NEAR(descriptors[i].deviation[f], 0, 1e-3);
      }
}

TEST(GaborBank, HasThePapersKernelSizes) {
  const GaborBank bank;
  for (int i = 0; i < 5; ++i) EXPECT_EQ(2 * bank.radius(i) + 1, (std::vector{17, 21, 25, 31, 37})[std::size_t(i)]);
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(bank.wave_number(i), pi / 2 / std::pow(std::sqrt(1.5), i - 2), 1e-12);
}

TEST(GaborBank, GivesTheDefinedMagnitudesEverywhere) {
  expect_defined_magnitudes({}, {90, 70}, {{40, 30}, {0, 0}, {88, 68}, {89, 69}, {41, 31}, {2, 60}, {60, 2}});
}

TEST(GaborBank, GivesTheDefinedMagnitudesForOtherStridesAndDirections) {
  expect_defined_magnitudes({.directions = 5, .stride = 1}, {61, 83}, {{30, 41}, {0, 82}, {60, 0}});
  expect_defined_magnitudes({.directions = 4, .scales = 2, .stride = 3}, {64, 48}, {{33, 30}, {63, 47}, {4, 2}});
}

TEST(GaborBank, GivesTheDefinedMagnitudesOnImagesSmallerThanAKernel) {
  expect_defined_magnitudes({}, {5, 3}, {{0, 0}, {4, 2}});
  expect_defined_magnitudes({}, {1, 1}, {{0, 0}});
}

TEST(GaborBank, GivesMeanAndDeviationOverTheGridPixels) {
  const GaborBank bank;
  const cv::Mat grey = random_grey({80, 60}, 3);
  const auto descriptor = describe(bank, grey, surfaces_of(grey.size(), {{21, 15, 31, 22}})).at(0);
  for (const auto& [scale, j] : {std::pair(0, 0), {1, 4}, {4, 2}}) {
    double sum = 0, square = 0, count = 0;
    for (int v = 16; v < 15 + 22; v += 2)
      for (int u = 22; u < 21 + 31; u += 2) {
        const double value = defined_magnitude(bank, grey, u, v, scale, j);
        sum += value, square += value * value, ++count;
      }
    const double mean = sum / count;
    EXPECT_NEAR(descriptor.mean[std::size_t(scale * 6 + j)], mean, 0.02);
    EXPECT_NEAR(descriptor.deviation[std::size_t(scale * 6 + j)], std::sqrt(square / count - mean * mean), 0.02);
  }
}

TEST(GaborBank, AnswersAFittingWaveWithHalfItsAmplitudeAndIgnoresBrightness) {
  cv::Mat colour(160, 160, CV_8UC3), grey;
  draw_grating(colour, {0, 0, 160, 160}, 4, 30);
  cv::extractChannel(colour, grey, 0);
  const auto wave = describe({}, grey, surfaces_of(grey.size(), {{40, 40, 80, 80}})).at(0);
  EXPECT_NEAR(wave.mean[2 * 6 + 1], 50, 0.5);
  EXPECT_LT(wave.mean[2 * 6 + 4], 1);  // the same wavelength at a right angle
  const auto plain = describe({}, cv::Mat(160, 160, CV_8UC1, cv::Scalar(255)), surfaces_of({160, 160}, {{0, 0, 9, 9}}));
  for (const float mean : plain.at(0).mean) EXPECT_NEAR(mean, 0, 1e-3);
}

TEST(GaborBank, GivesTheSameForAnyNumberOfThreads) {
  const cv::Mat grey = random_grey({320, 240}, 11);
  const SurfaceSet surfaces = surfaces_of(grey.size(), {{3, 5, 200, 210}, {210, 9, 100, 100}, {211, 120, 1, 1}});
  const auto with_threads = [&](std::size_t threads) {
    const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
    return describe({}, grey, surfaces);
  };
  const auto one = with_threads(1), eight = with_threads(8);
  for (std::size_t i = 0; i < one.size(); ++i) {
    EXPECT_EQ(one[i].mean, eight[i].mean);
    EXPECT_EQ(one[i].deviation, eight[i].deviation);
  }
}

// What is outside the box counts for the responses within it, and is not computed.
TEST(GaborBank, AnswersInABoxAsInTheWholeImage) {
  const GaborBank bank;
  const cv::Mat grey = random_grey({90, 70}, 5);
  cv::Mat_<uchar> mask(grey.size(), uchar{0});
  EXPECT_TRUE(grid_box(mask, bank.stride).empty());
  mask(cv::Rect(21, 15, 32, 22)).setTo(1);
  const cv::Rect box = grid_box(mask, bank.stride);
  EXPECT_EQ(box, cv::Rect(10, 7, 17, 12));
  const GaborResponses part(bank, grey, box), whole(bank, grey, {0, 0, 45, 35});
  for (int row = box.y; row < box.y + box.height; ++row)
    for (std::size_t filter = 0; filter < bank.filters(); ++filter)
      for (int column = box.x; column < box.x + box.width; ++column)
        ASSERT_EQ(*part.at(row, filter, column), *whole.at(row, filter, column)) << row << ' ' << filter;
}

TEST(GaborBank, OfNoSurfaceIsEmpty) {
  EXPECT_TRUE(describe({}, random_grey({20, 20}, 1), surfaces_of({20, 20}, {})).empty());
}

double r_ga(const test::KnownScene& known, int a, int b) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*Gabor({}).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

/// Two patches, each well inside the grating around it.
test::KnownScene gratings(double wavelength_0, double degrees_0, double wavelength_1, double degrees_1) {
  auto scene = test::render({{{60, 60, 100, 100}, before, facing}, {{360, 60, 100, 100}, before, facing}});
  draw_grating(scene.frame.colour, {0, 0, 260, 260}, wavelength_0, degrees_0);
  draw_grating(scene.frame.colour, {300, 0, 260, 260}, wavelength_1, degrees_1);
  return scene;
}

TEST(Gabor, IsNearZeroForATurnedGrating) {
  EXPECT_NEAR(r_ga(gratings(4, 0, 4, 0), 0, 1), 0, 0.01);
  EXPECT_NEAR(r_ga(gratings(4, 0, 4, 30), 0, 1), 0, 0.03);
  EXPECT_NEAR(r_ga(gratings(4, 0, 4, 60), 0, 1), 0, 0.03);
  EXPECT_NEAR(r_ga(gratings(6, 150, 6, 60), 0, 1), 0, 0.03);
}

TEST(Gabor, IsLargeForAnotherWavelength) {
  EXPECT_GT(r_ga(gratings(3, 0, 6, 0), 0, 1), 1);
  EXPECT_GT(r_ga(gratings(4, 0, 4.9, 0), 0, 1), 0.3);
}

TEST(Gabor, IsOneBetweenTextureAndNone) {
  auto scene = gratings(4, 0, 4, 0);
  scene.frame.colour(cv::Rect(300, 0, 260, 260)).setTo(cv::Scalar::all(128));
  EXPECT_NEAR(r_ga(scene, 0, 1), 1, 1e-3);
}

TEST(Gabor, IsNearZeroForNoiseBelowTheLeastEnergy) {
  auto scene = gratings(4, 0, 4, 0);
  scene.frame.colour.setTo(cv::Scalar::all(100));
  EXPECT_NEAR(r_ga(scene, 0, 1), 0, 1e-3);
  // A grid of single grey levels in one of the patches.
  for (int v = 0; v < 260; v += 7)
    for (int u = 0; u < 260; u += 7) scene.frame.colour.at<cv::Vec3b>(v, u) = cv::Vec3b::all(101);
  EXPECT_LT(r_ga(scene, 0, 1), 0.1);
}

TEST(Gabor, IsSymmetricAndInRangeForAnySurfaces) {
  const std::vector<cv::Rect> rectangles{{0, 0, 1, 1},    {1, 1, 1, 1},    {3, 3, 40, 1},  {100, 3, 1, 90},
                                         {7, 11, 55, 43}, {70, 60, 13, 5}, {119, 89, 1, 1}};
  std::vector<test::PlanarPatch> patches;
  for (const cv::Rect& r : rectangles) patches.push_back({r, before, facing});
  auto scene = test::render(patches, test::kinect(120, 90));
  cv::cvtColor(random_grey({120, 90}, 5), scene.frame.colour, cv::COLOR_GRAY2BGR);
  const int count = int(scene.surfaces.surfaces.size());
  ASSERT_EQ(count, int(rectangles.size()));
  for (int a = 0; a < count; ++a)
    for (int b = 0; b < count; ++b) {
      const double value = r_ga(scene, a, b);
      EXPECT_EQ(value, r_ga(scene, b, a));
      EXPECT_GE(value, 0);
      EXPECT_LE(value, 2);
    }
}

TEST(Gabor, RefusesKernelsOfUnreasonableSize) {
  Gabor::Params params;
  params.scales = 8;
  params.spacing = 4;
  EXPECT_THROW(Gabor{params}, ConfigError);
}

TEST(Gabor, TakesPatchesOfPixelsWithoutDepth) {
  auto scene = test::rectangle_before_wall();
  cv::RNG(4).fill(scene.frame.colour, cv::RNG::UNIFORM, 0, 256);
  const auto r_ga = [&] {
    double value = -1;
    (*Gabor({}).bind(Scene(scene.frame, scene.patches, scene.surfaces)))({0, 1, nullptr}, {&value, 1});
    return value;
  };
  const double with_depth = r_ga();
  scene.frame.depth(cv::Rect(0, 0, 640, 300)).setTo(0);
  EXPECT_EQ(r_ga(), with_depth);
  scene.frame.depth.setTo(0);
  EXPECT_EQ(r_ga(), with_depth);
}

}  // namespace
}  // namespace gestalt
