// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/depth_noise.h"

#include <map>

namespace gestalt {

namespace {

// kinect_v1: axial noise of Nguyen, Izadi, Lovell, "Modeling Kinect sensor noise for improved 3D reconstruction and
// tracking" (2012), 0.0012 + 0.0019 (z - 0.4)^2. realsense: stereo, z^2 * 0.08 px / (425 px * 0.05 m) after Intel's
// tuning guide for the D400 series. azure_kinect: time of flight, about 1 mm a metre within its range.
const std::map<std::string, DepthNoise>& presets() {
  static const std::map<std::string, DepthNoise> presets{{"kinect_v1", {0.0015, -0.0015, 0.0019}},
                                                         {"realsense", {0.001, 0, 0.0038}},
                                                         {"azure_kinect", {0.0005, 0.001, 0}}};
  return presets;
}

}  // namespace

const Parameters<SensorParams>& SensorParams::parameters() {
  using P = SensorParams;
  static const auto parameters =
      Parameters<P>()
          .choice("noise", &P::noise, {"kinect_v1", "realsense", "azure_kinect", "custom"},
                  "noise of the depth readings; custom: sigma(z) = constant + linear z + quadratic z^2")
          .real("constant", &P::constant, -1, 1, "m", "of custom noise")
          .real("linear", &P::linear, -1, 1, "", "of custom noise")
          .real("quadratic", &P::quadratic, -1, 1, "1/m", "of custom noise");
  return parameters;
}

DepthNoise SensorParams::depth_noise() const {
  return noise == "custom" ? DepthNoise{constant, linear, quadratic} : presets().at(noise);
}

}  // namespace gestalt
