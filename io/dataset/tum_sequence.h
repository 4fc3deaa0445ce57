// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/frame_files.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The frames of a sequence of the TUM RGB-D benchmark, by rgb.txt and depth.txt, in order of time: the images that are
/// nearest in time go together, at most 0.02 s apart, each in one frame. Throws InputError with the line.
GESTALT_EXPORT std::vector<FrameFiles> find_tum_frames(const std::filesystem::path& sequence);

/// Depth has 5000 units a metre, unless options or their camera tell another unit. Without a camera in the options, or
/// a camera.yaml of the sequence or a parent folder, the factory's of a Kinect (525 px, 640x480), as the benchmark
/// advises.
GESTALT_EXPORT ConvertedScene read_tum_frame(const FrameFiles& frame, const ReadOptions& options = {});

}  // namespace gestalt
