// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace gestalt {

/// Where colour changes. An edge is one pixel wide: elsewhere strength is 0.
struct ColourEdges {
  cv::Mat_<float> strength;   ///< of the largest change, CIELAB units a pixel, >= 0
  cv::Mat_<float> direction;  ///< of that change, rad in [0, pi): 0 to the right, pi / 2 down
};

/// Ridges of the structure tensor of the smoothed image, summed over the channels of CIELAB (Di Zenzo, A note on the
/// gradient of a multi-image, CVGIP 1986). colour: CV_8UC3, blue green red. smoothing: deviation of the Gaussian,
/// pixels, > 0.
ColourEdges find_colour_edges(const cv::Mat& colour, double smoothing);

}  // namespace gestalt
