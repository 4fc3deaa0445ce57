// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Makes the frame of images that a camera took, as set_frame(): with camera_for() their size. Where its lens moves
/// pixels by less than about 1 % of the image's radius, that is a warning; beyond, depth, colour and the input's
/// ground truth are rectified, which is a note. image is for messages.
void set_frame_of_images(Input& input, const std::string& name, const cv::Mat& colour, DepthReading depth,
                         const CameraFile& camera, const std::filesystem::path& image);

}  // namespace gestalt
