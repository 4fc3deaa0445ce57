// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

// Images of any file that people have them in: PNG, JPEG, TIFF, PGM and PPM, PFM, EXR, and arrays of .npy.
// What a file is, its first bytes tell, not its extension. All throw InputError naming the file and the remedy for what
// cannot be read, is incomplete, or has more than 2^26 pixels.

/// Whether the extension is one of an image file, depth's arrays included.
GESTALT_EXPORT bool has_image_extension(const std::filesystem::path& file);

/// Whether a file can be a depth image, by its content: whether read_depth_image() reads it.
GESTALT_EXPORT bool is_depth_image(const std::filesystem::path& file);

/// CV_8UC3, blue green red, from grey, colour, with or without alpha, of 8 or 16 bits or floats (as_colour()). Pixels
/// are where they are stored: an orientation in the file, by which depth is not turned, is one of the notes.
cv::Mat read_colour_image(const std::filesystem::path& file, std::vector<std::string>& notes);

/// CV_16UC1: whole numbers in a unit that the file does not tell; or CV_32FC1: floats, metres by convention, where what
/// is not a number is not a measurement.
cv::Mat read_depth_image(const std::filesystem::path& file);

}  // namespace gestalt
