// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/base/export.h"
#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/scene/depth_noise.h"

namespace gestalt {

/// Section `sensor` of a config: which sensor made the frames.
struct SensorParams {
  std::string noise = "kinect_v1";  ///< a preset, or "custom": the three numbers below
  double constant = DepthNoise{}.constant;
  double linear = DepthNoise{}.linear;
  double quadratic = DepthNoise{}.quadratic;

  GESTALT_EXPORT static const Parameters<SensorParams>& parameters();

  DepthNoise depth_noise() const;
};

}  // namespace gestalt
