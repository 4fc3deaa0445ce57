// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <yaml-cpp/yaml.h>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Whether a YAML map is a camera_info of ROS: as camera_calibration writes it (image_width, camera_matrix) or as a
/// printed message (width, K or k).
bool is_camera_info(const YAML::Node& root);

/// The intrinsics, by K. Throws InputError with file, line and column for what is missing or no number, and for a lens
/// that distorts: our cameras are pinholes.
CameraFile read_camera_info(const std::filesystem::path& file, const YAML::Node& root);

}  // namespace gestalt
