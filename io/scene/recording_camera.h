// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The file that camera_of_frame() takes without options: scene_camera.json of BOP; else a file of the folder, or of
/// its parent, by one of the names that data sets give it (camera.yaml, cam_K.txt, intrinsic/intrinsic_depth.txt, ...),
/// or the text of the folder's name that ScanNet has; else that of find_camera_file(); else nothing.
std::optional<std::filesystem::path> camera_file_of_frame(const std::filesystem::path& depth,
                                                          const std::filesystem::path& recording);

/// The camera of a depth image of this size in a recording or scene folder: that of the options; else that of
/// camera_file_of_frame(); else, for lists and images as those of TUM's benchmark, its camera and its 5000 units a
/// metre, which is a warning. Throws InputError where there is none.
CameraFile camera_of_frame(const std::filesystem::path& depth, const std::filesystem::path& recording, cv::Size size,
                           const ReadOptions& options, std::vector<std::string>& warnings);

}  // namespace gestalt
