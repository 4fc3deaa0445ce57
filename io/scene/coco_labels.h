// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The objects of an image of this size in instances of COCO: 1 for the first annotation, 2 for the second, ..., 0 in
/// none; of overlapping ones the smaller wins. Segmentations are run lengths, as lists or packed in a text, or
/// polygons. The image is the only one of this size, else the one whose file_name has this stem. Annotations of a crowd
/// are left out. Throws InputError naming the file and the annotation.
GESTALT_EXPORT cv::Mat_<int> read_coco_labels(const std::filesystem::path& file, cv::Size size,
                                              const std::string& stem);

}  // namespace gestalt
