// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "frame_files.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// What a folder of images may have beside those of the frame: a recording's masks are of all of its frames.
enum class GroundTruth { none, beside };

/// Whether a path is an image file that may be a depth image: a scene by itself.
bool is_frame(const std::filesystem::path& path);

/// Reads the frame of a depth image, its colour that of the options or of files_of_frame(). The camera is that of the
/// options, else that of camera_of_frame(). Throws InputError.
Input read_frame_scene(const std::filesystem::path& depth, const ReadOptions& options);

/// Reads images that belong together. Colour of another size than depth's is registered, where the second camera is in
/// the folder, or resampled, where both may show the same view; else it is refused. Ground truth beside is that of
/// read_ground_truth_beside(). name is for messages. Throws InputError.
Input read_frame_files(const FrameFiles& files, const std::filesystem::path& folder, const std::filesystem::path& name,
                       const ReadOptions& options, GroundTruth ground_truth);

}  // namespace gestalt
