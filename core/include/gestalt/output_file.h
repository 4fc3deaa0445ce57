// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string_view>

#include <opencv2/core.hpp>

#include "gestalt/export.h"

namespace gestalt {

/// Writes bytes under a temporary name beside the file and renames it: readers see the old file, the new one, or none.
/// Makes missing parent folders. Throws OutputError naming the file and the system's reason; leaves no temporary file.
GESTALT_EXPORT void write_file(const std::filesystem::path& file, std::string_view bytes);

/// Same, for an image as PNG.
GESTALT_EXPORT void write_png(const std::filesystem::path& file, const cv::Mat& image);

}  // namespace gestalt
