// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

namespace gestalt::synthesis {

/// 255 within `radius` pixels of a depth jump (between measured surfaces, or to nothing). depth in metres, 0 = nothing.
cv::Mat_<uchar> beside_jumps(const cv::Mat_<float>& depth, int radius);

/// The mean of the values in a square window around each pixel that differ from its own by less than `tolerance`, taken
/// along rows and then along columns: creases become round, jumps stay. 0 = no value, neither given nor taken.
cv::Mat_<float> window_mean(const cv::Mat_<float>& values, int radius, float tolerance);

}  // namespace gestalt::synthesis
