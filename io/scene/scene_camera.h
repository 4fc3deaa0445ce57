// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <string>
#include <vector>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The camera that is given, else that of find_camera_file(), else nothing.
std::optional<CameraFile> choose_camera(const std::filesystem::path& scene, const std::optional<CameraFile>& given);

/// For messages: its file, or "the given camera".
std::string camera_name(const CameraFile& camera);

cv::Size size_of(const Camera& camera);

/// "640x480".
std::string text(cv::Size size);

/// The camera for an image of this size: as it is where its own is equal or not told, scaled where the images have one
/// aspect. What was done, and what was guessed when its file was read, is among the input's notes and warnings. Throws
/// InputError for another aspect, and for a principal point outside the image.
Camera camera_for(const CameraFile& camera, cv::Size size, const std::filesystem::path& image, Input& input);

/// Adds a warning where pixels are more than half as high again as wide, or as wide as high: no sensor has such. name:
/// of the input.
void question_pixels(const std::string& name, const Camera& camera, std::vector<std::string>& warnings);

}  // namespace gestalt
