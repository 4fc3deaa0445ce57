// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <nlohmann/json_fwd.hpp>
#include <opencv2/core.hpp>
#include <string>
#include <string_view>

#include "gestalt/core/scene/frame.h"

namespace gestalt {

// A frame with labels as files of other programs. Labels are of the frame's size, or empty.

/// A PCD file (0.7, binary), organized: x y z (metres; NaN without depth), rgb where there is colour, label (U 4) where
/// there are labels.
GESTALT_EXPORT std::string encode_pcd(const Frame& frame, const cv::Mat_<std::uint16_t>& labels);

/// A PLY file (1.0, binary_little_endian) of the pixels with depth, row by row: x y z, red green blue where there is
/// colour, label (ushort) where there are labels.
GESTALT_EXPORT std::string encode_ply(const Frame& frame, const cv::Mat_<std::uint16_t>& labels);

/// Instances in the format of COCO: one image, file_name, and one annotation of the category "object" for each label
/// above 0, with bbox (x, y, width, height), area (pixels) and segmentation as uncompressed run lengths, column by
/// column, of which the first counts pixels outside.
GESTALT_EXPORT nlohmann::ordered_json coco_instances(const cv::Mat_<std::uint16_t>& labels,
                                                     const std::string& file_name);

}  // namespace gestalt
