// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/base/export.h"
#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// Section `sensor` of a config: which sensor made the frames.
struct SensorParams {
  std::string noise = "kinect_v1";  ///< auto: from the frame; a preset, or "custom": the three numbers below
  double constant = DepthNoise{}.constant;
  double linear = DepthNoise{}.linear;
  double quadratic = DepthNoise{}.quadratic;

  GESTALT_EXPORT static const Parameters<SensorParams>& parameters();

  /// Noise of a frame's depth. auto: that of azure_kinect, times what estimate_noise() finds, bounded by 0.6 and 1;
  /// azure_kinect where it finds nothing.
  DepthNoise depth_noise(const Frame& frame) const;
};

}  // namespace gestalt
