// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <string>
#include <string_view>

namespace gestalt {

/// Decodes an image file with OpenCV's codecs, its pixels as they are stored. They are loaded when the first such file
/// comes, from the library lib/gestalt/image_codecs.so beside ours. Gives "", or what is wrong. Thread-safe.
std::string decode_with_opencv(std::string_view bytes, cv::Mat& image);

/// The same of an EXR file's depth, CV_32FC1: its channel Z, also of a layer, else its only channel. "" and no image
/// where it has neither.
std::string decode_exr_depth(std::string_view bytes, cv::Mat& image);

}  // namespace gestalt
