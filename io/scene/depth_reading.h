// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <opencv2/core.hpp>
#include <string>

#include "gestalt/io/scene/depth_unit.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Depth as an input gives it, times its unit.
struct DepthReading {
  cv::Mat_<float> metres;  ///< may hold NaN, infinities and what no sensor measures
  DepthUnit unit;
  bool whole_numbers = false;  ///< what the file holds
  DepthKind kind = DepthKind::plain;
};

/// Of an image or array of whole numbers. camera: whose depth_scale counts where the options tell none.
GESTALT_EXPORT DepthReading depth_reading(const cv::Mat_<std::uint16_t>& raw, const ReadOptions& options,
                                          const std::optional<CameraFile>& camera);

/// Of an image or array of floats, which is copied.
GESTALT_EXPORT DepthReading float_reading(const cv::Mat_<float>& raw, const ReadOptions& options);

/// Makes the frame of an input: every reader ends with it. What the depth cannot be in its unit is refused, what it
/// probably is not is one of the input's warnings (depth_plausibility.h). Throws InputError as make_frame() does.
GESTALT_EXPORT void set_frame(Input& input, const std::string& name, const cv::Mat& colour, DepthReading depth,
                              const Camera& camera);

}  // namespace gestalt
