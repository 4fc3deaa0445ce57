// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <opencv2/core.hpp>
#include <string_view>

#include "gestalt/core/base/export.h"

namespace gestalt {

// All throw InputError naming the file and the remedy for a file that is not a complete PNG, that has more than 2^26
// pixels, or has another kind of pixels than said.

/// Any image (grey, colour, palette, with or without alpha, of up to 16 bits) as CV_8UC3, blue green red; alpha is
/// dropped, and 16 bits are reduced as as_colour() says.
GESTALT_EXPORT cv::Mat read_colour_png(const std::filesystem::path& file);

/// One channel of 16 bits.
GESTALT_EXPORT cv::Mat_<std::uint16_t> read_depth_png(const std::filesystem::path& file);

/// The same of bytes that are not a file's; file names them in messages.
cv::Mat colour_of_png(const std::filesystem::path& file, std::string_view bytes);
cv::Mat_<std::uint16_t> depth_of_png(const std::filesystem::path& file, std::string_view bytes);

/// One channel of 8 or 16 bits.
GESTALT_EXPORT cv::Mat_<std::uint16_t> read_label_png(const std::filesystem::path& file);

}  // namespace gestalt
