// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <yaml-cpp/yaml.h>

#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

class CalibrateNoise : public testing::Test {
 protected:
  /// A slope from 1 to 1.6 m whose readings alternate by 4 mm about the plane: their deviation is 4 mm everywhere.
  std::filesystem::path rough_slope() const {
    cv::Mat_<std::uint16_t> depth(480, 640);
    for (int v = 0; v < depth.rows; ++v)
      for (int u = 0; u < depth.cols; ++u)
        depth(v, u) = std::uint16_t(1000 / (1 - 0.375 * v / 479) + ((u + v) % 2 == 0 ? 4 : -4));
    const auto scene = write_scene(folder.path() / "scenes" / "slope", depth);
    folder.write(scene / "camera.yaml", "{width: 640, height: 480, fx: 525, fy: 525, cx: 319.5, cy: 239.5}");
    return scene;
  }

  TemporaryFolder folder;
};

TEST_F(CalibrateNoise, PrintsASectionOfAConfig) {
  const Outcome outcome = run_gestalt({"calibrate-noise", rough_slope()});
  expect_success(outcome);
  const YAML::Node sensor = YAML::Load(outcome.out)["sensor"];
  ASSERT_TRUE(sensor.IsMap()) << outcome.out;
  EXPECT_EQ(sensor["noise"].as<std::string>(), "custom");
  const double z = 1.3, sigma = sensor["constant"].as<double>() + sensor["linear"].as<double>() * z +
                                sensor["quadratic"].as<double>() * z * z;
  EXPECT_NEAR(sigma, 0.004, 0.0002);
  EXPECT_GT(occurrences("\n#", outcome.out), 2) << outcome.out;  // a line for each range of depths
}

TEST_F(CalibrateNoise, PrintsTheSameAsJson) {
  const Outcome outcome = run_gestalt({"calibrate-noise", rough_slope(), "--json"});
  expect_success(outcome);
  const auto json = nlohmann::json::parse(outcome.out);
  EXPECT_EQ(json.at("scenes"), 1);
  ASSERT_GE(json.at("bins").size(), 2u);
  std::size_t samples = 0;
  for (const auto& bin : json.at("bins")) {
    EXPECT_NEAR(bin.at("sigma").get<double>(), 0.004, 0.0002);
    EXPECT_GE(bin.at("windows"), 20);
    samples += bin.at("samples").get<std::size_t>();
  }
  EXPECT_LE(samples, 4 * 640u * 480u);  // windows overlap by half, both ways
}

TEST_F(CalibrateNoise, RefusesScenesThatShowNoSurface) {
  cv::Mat_<std::uint16_t> speck(small_height, small_width, std::uint16_t{0});
  speck(30, 40) = 1000;
  expect_refused(run_gestalt({"calibrate-noise", write_scene(folder.path() / "speck", speck)}), 3,
                 {"windows", "more scenes"});
  expect_refused(run_gestalt({"calibrate-noise", folder.path() / "absent"}), 3, {"absent"});
  EXPECT_EQ(run_gestalt({"calibrate-noise"}).code, 2);
}

}  // namespace
}  // namespace gestalt::test
