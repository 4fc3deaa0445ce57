// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <opencv2/core/affine.hpp>
#include <optional>

#include "gestalt/io/scene/input.h"

namespace gestalt {

inline constexpr const char* colour_camera_name = "camera_color.yaml";
inline constexpr const char* extrinsics_name = "extrinsics.txt";

/// The camera of colour images that are not registered to depth.
struct ColourCamera {
  Camera intrinsics;
  std::filesystem::path file;
  cv::Affine3d from_depth = cv::Affine3d::Identity();  ///< from the depth camera's frame to this one's, metres
  std::filesystem::path extrinsics;                    ///< where that was read; empty: the identity is assumed
};

/// Of a folder: camera_color.yaml, or camera_rgb.yaml, or intrinsic/intrinsic_color.txt as ScanNet has it; and
/// extrinsics.txt, 16 numbers, row by row. Nothing where there is none for images of this size. Throws InputError for
/// files that cannot be read.
std::optional<ColourCamera> find_colour_camera(const std::filesystem::path& folder, cv::Size size);

}  // namespace gestalt
