// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/scene/depth_plausibility.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "gestalt/core/base/error.h"

namespace gestalt::test {
namespace {

const Camera camera{160, 120, 140, 140, 79.5, 59.5};

/// A table seen from above at an angle, 0.5 to 1.4 m away, with the noise of structured light.
cv::Mat_<double> table(double factor = 1) {
  std::mt19937 random(7);
  std::normal_distribution<double> noise(0, 0.0007);
  cv::Mat_<double> depth(camera.height, camera.width);
  for (int v = 0; v < depth.rows; ++v)
    for (int u = 0; u < depth.cols; ++u) {
      const double z = 0.45 / (0.5 + 0.8 * (v - camera.cy) / camera.fy);
      depth(v, u) = factor * (z + noise(random) * z * z);
    }
  return depth;
}

DepthReading reading(const cv::Mat_<double>& numbers, double unit, bool whole, bool told = false) {
  DepthReading depth{cv::Mat_<float>(numbers.size()), {unit, "a test", told}, whole, DepthKind::plain};
  for (std::size_t i = 0; i < numbers.total(); ++i) {
    const double number = numbers.ptr<double>()[i];
    depth.metres.ptr<float>()[i] = float(unit * (whole ? std::round(number) : number));
  }
  return depth;
}

/// "ok", or the warnings, or "refused: " and why.
std::string verdict(const DepthReading& depth) try {
  std::vector<std::string> warnings;
  question_depth("x", depth, camera, warnings);
  return warnings.empty() ? "ok" : warnings.front();
} catch (const InputError& error) {
  return std::string("refused: ") + error.what();
}

void expect_told(const std::string& verdict, const std::string& begin, const std::string& part) {
  EXPECT_TRUE(verdict.starts_with(begin)) << verdict;
  EXPECT_NE(verdict.find(part), std::string::npos) << verdict;
}

TEST(DepthPlausibility, WhatIsRightIsNotDoubted) {
  EXPECT_EQ(verdict(reading(table(1000), 0.001, true)), "ok");
  EXPECT_EQ(verdict(reading(table(10000), 0.0001, true)), "ok");
  EXPECT_EQ(verdict(reading(table(), 1, false)), "ok");
  EXPECT_EQ(verdict(reading(table(0.25), 1, false)), "ok");  // 0.12 to 0.35 m
  EXPECT_EQ(verdict(reading(table(8), 1, false)), "ok");     // a hall
  EXPECT_EQ(verdict(reading(cv::Mat_<double>(2, 2, 1.0), 1, false)), "ok");
}

TEST(DepthPlausibility, ARoomWithTheNoiseOfItsDistanceIsNotDoubted) {
  cv::Mat_<double> room = table(5000);
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 1);
  for (double& depth : room) depth += noise(random) * 1.4e-6 * depth * depth;
  EXPECT_EQ(verdict(reading(room, 0.001, true)), "ok");
}

TEST(DepthPlausibility, MillimetresAreNoMetres) {
  expect_told(verdict(reading(table(1000), 1, false)), "refused: x: ", "give --unit mm (0.5");
  expect_told(verdict(reading(table(100), 1, false)), "refused: x: ", "give --unit cm (0.5");
  EXPECT_EQ(verdict(reading(table(1000), 0.001, false, true)), "ok");
  expect_told(verdict(reading(table(1000), 1, false, true)),
              "x: ", "outside the range of depth sensors");  // told: not refused
  expect_told(verdict(reading(table(0.001), 1, false)), "refused: x: ", "--unit km");
}

TEST(DepthPlausibility, ScaleInMillimetresIsNoScaleInMetres) {
  expect_told(verdict(reading(table(1000), 1, true)), "refused: x: ", "give --unit mm");
}

TEST(DepthPlausibility, FinerUnitsAreDoubted) {
  expect_told(verdict(reading(table(10000), 0.001, true)), "x: ", "--unit 0.1mm (0.5");
  expect_told(verdict(reading(table(5000), 0.001, true)), "x: ", "--unit 0.2mm (0.5");
  expect_told(verdict(reading(table(4000), 0.001, true)), "x: ", "--unit 0.25mm (0.5");
  expect_told(verdict(reading(table(100), 0.001, true)), "x: ", "--unit cm");
  EXPECT_EQ(verdict(reading(table(10000), 0.001, true, true)), "ok");
}

TEST(DepthPlausibility, WholeMetresHaveNoDepth) {
  expect_told(verdict(reading(table(2), 0.001, true)), "refused: x: ", "rounded to metres");
  cv::Mat_<double> rounded = table(2);
  for (double& depth : rounded) depth = std::round(depth);
  expect_told(verdict(reading(rounded, 1, false)), "refused: x: ", "rounded to metres");
}

TEST(DepthPlausibility, NumbersOfOtherMeaningAreNamed) {
  cv::Mat_<double> numbers = table(1000);
  for (double& depth : numbers) depth = 8 * std::round(depth);
  expect_told(verdict(reading(numbers, 0.001, true)), "refused: x: ", "--depth-kind rotated");
  numbers = table(150);
  for (double& depth : numbers) depth = 257 * std::round(depth);
  expect_told(verdict(reading(numbers, 0.001, true)), "refused: x: ", "8-bit picture");
  double largest = 0;
  numbers = table();
  cv::minMaxLoc(numbers, nullptr, &largest);
  for (double& depth : numbers) depth *= 65535 / largest;
  expect_told(verdict(reading(numbers, 0.001, true)), "x: ", "scaled to the 16-bit range");
  for (double& depth : numbers) depth /= 65535;
  expect_told(verdict(reading(numbers, 1, false)), "x: ", "scaled to 0..1");
}

TEST(DepthPlausibility, DistancesAlongRaysCurvePlanes) {
  cv::Mat_<double> distances = table();
  for (int v = 0; v < distances.rows; ++v)
    for (int u = 0; u < distances.cols; ++u) {
      const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
      distances(v, u) *= std::sqrt(x * x + y * y + 1);
    }
  expect_told(verdict(reading(distances, 1, false)), "x: planes are curved", "--depth-kind radial");
  DepthReading told = reading(distances, 1, false);
  told.kind = DepthKind::radial;
  EXPECT_EQ(verdict(told), "ok");
}

TEST(DepthUnit, IsANumberAndALength) {
  for (const auto& [text, metres] : {std::pair("m", 1.0),
                                     {"mm", 1e-3},
                                     {"0.1mm", 1e-4},
                                     {"0.25 mm", 2.5e-4},
                                     {"cm", 0.01},
                                     {"um", 1e-6},
                                     {"km", 1000.0}})
    EXPECT_NEAR(metres_of_unit(text).value_or(0), metres, 1e-12) << text;
  for (const char* text : {"", "inch", "0mm", "-1mm", "mm2", "1e9km", "0.1"})
    EXPECT_FALSE(metres_of_unit(text)) << text;
  EXPECT_EQ(unit_name(0.001), "mm");
  EXPECT_EQ(unit_name(0.0002), "0.2 mm");
}

}  // namespace
}  // namespace gestalt::test
