// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The camera that is given, else that of find_camera_file(), else nothing.
std::optional<CameraFile> choose_camera(const std::filesystem::path& scene, const std::optional<CameraFile>& given);

/// For messages: its file, or "the given camera".
std::string camera_name(const CameraFile& camera);

cv::Size size_of(const Camera& camera);

/// "640x480".
std::string text(cv::Size size);

/// Throws InputError unless the camera is made for images of this size, which that of the file has.
void check_size(const CameraFile& camera, cv::Size size, const std::filesystem::path& image);

}  // namespace gestalt
