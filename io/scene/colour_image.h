// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Colour of any kind of pixels as CV_8UC3, channels in the order that they have; grey becomes three equal channels,
/// and alpha is dropped. Floats are from 0 to 1, or from 0 to 255 where their mean is above 1; whole numbers of more
/// than 8 bits are from 0 to 65535, or from 0 to 255 where none is above that. problem: "", or what is wrong; the image
/// is then empty.
GESTALT_EXPORT cv::Mat as_colour(const cv::Mat& image, std::string& problem);

/// Colour of the same view with another number of pixels, resampled.
cv::Mat resized(const cv::Mat& colour, cv::Size size);

/// Whether two images may show the same view: height and width are in one ratio, to half a pixel of the smaller one or
/// half a per cent: colour of ScanNet is 1296x968, depth 640x480.
bool same_aspect(cv::Size a, cv::Size b);

}  // namespace gestalt
