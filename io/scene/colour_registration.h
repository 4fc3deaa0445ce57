// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/core/affine.hpp>

#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// A colour image as the depth camera would see it: each pixel with depth (m) takes the colour, interpolated, of the
/// pixel of the colour camera that its point is seen in; black where there is none. Of depth's size, which is kept, as
/// its pixels are what was measured. colour_from_depth takes points from the frame of the depth camera to that of the
/// colour camera (m).
cv::Mat registered_colour(const cv::Mat& colour, const Camera& colour_camera, const cv::Affine3d& colour_from_depth,
                          const cv::Mat_<float>& depth, const Camera& depth_camera);

}  // namespace gestalt
