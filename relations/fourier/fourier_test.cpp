// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "fourier.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

const Eigen::Vector3f before{0, 0, 1}, facing{0, 0, -1};

/// Two patches of a 160 x 120 image, whose grey values the test sets.
test::KnownScene two_patches() {
  return test::render({{{0, 0, 50, 120}, before, facing}, {{60, 10, 97, 100}, before, facing}}, test::kinect(160, 120));
}

void set_grey(test::KnownScene& scene, int surface, int (*grey)(int u, int v)) {
  for (const int pixel : scene.surfaces.surfaces[std::size_t(surface)].pixels) {
    const int u = pixel % scene.frame.width(), v = pixel / scene.frame.width();
    scene.frame.colour.at<cv::Vec3b>(v, u) = cv::Vec3b::all(uchar(grey(u, v)));
  }
}

int noise(int u, int v) { return (u * 7919 + v * 104729 + u * v * 31 + (u * u + v) % 13 * 977) % 256; }
int faint_noise(int u, int v) { return 120 + noise(u, v) % 7; }

double r_fo(const test::KnownScene& known, int a, int b) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  double value = -1;
  (*Fourier({}).bind(scene))({a, b, nullptr}, {&value, 1});
  return value;
}

/// The definition, word for word: eight-point transform at every pixel, five histograms of eight bins.
std::array<std::array<double, 8>, 5> histograms(const cv::Mat& grey, const std::vector<int>& pixels) {
  const int du[] = {1, 1, 0, -1, -1, -1, 0, 1}, dv[] = {0, 1, 1, 1, 0, -1, -1, -1};
  std::array<std::array<double, 8>, 5> result{};
  for (const int pixel : pixels) {
    const int u = pixel % grey.cols, v = pixel / grey.cols;
    for (int k = 0; k < 5; ++k) {
      std::complex<double> sum = 0;
      for (int n = 0; n < 8; ++n) {
        const int x = std::clamp(u + du[n], 0, grey.cols - 1), y = std::clamp(v + dv[n], 0, grey.rows - 1);
        sum += double(grey.at<uchar>(y, x)) * std::polar(1.0, -2 * std::numbers::pi * k * n / 8);
      }
      const double width = k == 0 ? 32 : 32.0 / (2 + 6 * k);
      const int bin = std::min(7, int(std::abs(sum) / 8 / width));
      result[std::size_t(k)][std::size_t(bin)] += 1.0 / double(pixels.size());
    }
  }
  return result;
}

double defined_r_fo(const test::KnownScene& known) {
  const Scene scene(known.frame, known.patches, known.surfaces);
  const auto p = histograms(scene.grey(), known.surfaces.surfaces[0].pixels);
  const auto q = histograms(scene.grey(), known.surfaces.surfaces[1].pixels);
  double sum = 0;
  for (std::size_t k = 0; k < 5; ++k)
    for (std::size_t i = 0; i < 8; ++i) sum += std::sqrt(p[k][i] * q[k][i]);
  return sum / 5;
}

TEST(Fourier, FollowsTheDefinition) {
  auto scene = two_patches();
  set_grey(scene, 0, noise);
  set_grey(scene, 1, faint_noise);
  const double expected = defined_r_fo(scene);
  EXPECT_GT(expected, 0.05);
  EXPECT_LT(expected, 0.95);
  // A magnitude on a bin's very edge may fall to either side: a few of 6000 pixels.
  EXPECT_NEAR(r_fo(scene, 0, 1), expected, 2e-3);
  EXPECT_EQ(r_fo(scene, 0, 1), r_fo(scene, 1, 0));
}

TEST(Fourier, IsOneForPlainPatchesOfOneGrey) {
  auto scene = two_patches();
  scene.frame.colour.setTo(cv::Scalar::all(77));
  EXPECT_NEAR(r_fo(scene, 0, 1), 1, 1e-6);
}

TEST(Fourier, OfPlainPatchesOfTwoGreysDiffersInTheFirstCoefficientOnly) {
  auto scene = two_patches();
  scene.frame.colour.setTo(cv::Scalar::all(20));
  scene.frame.colour(cv::Rect(55, 0, 105, 120)).setTo(cv::Scalar::all(220));
  EXPECT_NEAR(r_fo(scene, 0, 1), 4.0 / 5.0, 1e-6);
}

TEST(Fourier, IsOneForATextureAndItsQuarterTurn) {
  auto scene =
      test::render({{{20, 20, 40, 40}, before, facing}, {{80, 20, 40, 40}, before, facing}}, test::kinect(160, 120));
  const auto stripes = [](int along) { return uchar(along / 2 % 2 == 0 ? 60 : 180); };
  for (int v = 0; v < 120; ++v)
    for (int u = 0; u < 160; ++u) scene.frame.colour.at<cv::Vec3b>(v, u) = cv::Vec3b::all(stripes(u < 70 ? u : v));
  EXPECT_NEAR(r_fo(scene, 0, 1), 1, 1e-6);
}

TEST(Fourier, OfSinglePixelsAtTheImagesCornersIsDefined) {
  auto scene =
      test::render({{{0, 0, 1, 1}, before, facing}, {{159, 119, 1, 1}, before, facing}}, test::kinect(160, 120));
  set_grey(scene, 0, noise);
  set_grey(scene, 1, noise);
  EXPECT_NEAR(r_fo(scene, 0, 1), defined_r_fo(scene), 1e-6);
}

TEST(Fourier, WorksOnAnImageOfOnePixel) {
  const auto scene = test::render({{{0, 0, 1, 1}, before, facing}}, {1, 1, 1, 1, 0, 0});
  EXPECT_EQ(r_fo(scene, 0, 0), 1);
}

}  // namespace
}  // namespace gestalt
