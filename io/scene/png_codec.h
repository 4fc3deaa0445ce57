// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

// libpng without OpenCV's image files: those bring a hundred libraries of other formats with them, whose loading takes
// longer than a frame.

/// Decodes a whole PNG file into an image of its size: CV_8UC3 (blue, green, red; alpha is dropped) from any kind of up
/// to 8 bits, CV_16UC3 from 16 bits, or CV_8UC1 or CV_16UC1 from grey without alpha of as many bits. Gives "", or what
/// is wrong; image is then of no use.
std::string decode_png(std::string_view bytes, cv::Mat& image);

/// An image as the bytes of a PNG file. Throws OutputError.
GESTALT_EXPORT std::string encode_png(const cv::Mat& image);

}  // namespace gestalt
