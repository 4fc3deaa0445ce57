// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Reads a scene of arrays: depth (height, width), in metres if it is of floats, else in units of depth_scale (that of
/// the camera, else 0.001 m, where the file has none), unless the options tell the unit; rgb (height, width, 3) of
/// uint8 and label (height, width) of integers, if there; K (3, 3), for which a camera may be given instead. Throws
/// InputError naming the file and the array.
Input read_npz_scene(const std::filesystem::path& file, const ReadOptions& options);

/// The bytes of such a file, deflated: depth, depth_scale, K, and rgb and label where the scene has them.
std::string encode_npz_scene(const ConvertedScene& scene);

}  // namespace gestalt
