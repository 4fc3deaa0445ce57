// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/sensor_params.h"

#include <algorithm>
#include <map>

#include "gestalt/core/scene/noise_estimate.h"

namespace gestalt {

namespace {

// kinect_v1 (and Xtion, of the same sensor): axial noise of Nguyen, Izadi, Lovell, "Modeling Kinect sensor noise for
// improved 3D reconstruction and tracking" (3DIMPVT 2012): 0.0012 + 0.0019 (z - 0.4)^2.
//
// realsense (D435): Ahn, Chae, Lee, Lee, "Analysis and noise modeling of the Intel RealSense D435 for mobile robots"
// (UR 2019), axial part for a surface seen from the front. A D415 is quieter from pixel to pixel, but its errors are
// alike over tens of pixels, and over those it is nearly as noisy.
//
// azure_kinect: time of flight, from about 1 mm at 0.5 m to 4 mm at 3.5 m, which is well below the 17 mm of its data
// sheet (confirmed by Toelgyessy, Dekan, Chovanec, Hubinsky, "Evaluation of the Azure Kinect and its comparison to
// Kinect v1 and Kinect v2", Sensors 2021).
const std::map<std::string, DepthNoise>& presets() {
  static const std::map<std::string, DepthNoise> presets{{"kinect_v1", {0.0015, -0.0015, 0.0019}},
                                                         {"realsense", {0.00163, 0.00073, 0.00395}},
                                                         {"azure_kinect", {0.0005, 0.001, 0}}};
  return presets;
}

/// Of the azure_kinect preset. Frames of six sensors have 0.66 to 2.6 of it, but the larger part of a noisy one's
/// errors is alike over tens of pixels: planes follow it, and with more than the preset things that touch become one
/// patch (docs/accuracy.md).
constexpr double least_multiple = 0.6;

}  // namespace

const Parameters<SensorParams>& SensorParams::parameters() {
  using P = SensorParams;
  static const auto parameters =
      Parameters<P>()
          .choice("noise", &P::noise, {"auto", "kinect_v1", "realsense", "azure_kinect", "custom"},
                  "noise of the depth readings; auto: from the frame; custom: sigma(z) = constant + linear z + "
                  "quadratic z^2")
          .real("constant", &P::constant, -1, 1, "m", "of custom noise")
          .real("linear", &P::linear, -1, 1, "", "of custom noise")
          .real("quadratic", &P::quadratic, -1, 1, "1/m", "of custom noise");
  return parameters;
}

DepthNoise SensorParams::depth_noise(const Frame& frame) const {
  if (noise == "custom") return {constant, linear, quadratic};
  if (noise != "auto") return presets().at(noise);
  const DepthNoise& usual = presets().at("azure_kinect");
  const double multiple = std::clamp(estimate_noise(frame, usual).value_or(1), least_multiple, 1.0);
  return {multiple * usual.constant, multiple * usual.linear, multiple * usual.quadratic};
}

}  // namespace gestalt
