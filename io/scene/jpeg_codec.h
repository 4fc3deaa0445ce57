// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <string_view>

namespace gestalt {

// libjpeg without OpenCV's image files, as png_codec.h; and it tells of damage, which those decode to grey.

/// Decodes a whole JPEG file, grey or in colours, to CV_8UC3 (blue, green, red), as its pixels are stored: a note in
/// the file on how the camera was held turns nothing, as intrinsics are of the pixels. Up to most_pixels. Gives "", or
/// what is wrong; image is then of no use.
std::string decode_jpeg(std::string_view bytes, cv::Mat& image);

}  // namespace gestalt
