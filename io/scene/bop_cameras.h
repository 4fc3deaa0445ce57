// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// The cameras of a scene in the layout of BOP, scene_camera.json: one for each image, by its number.
inline constexpr const char* bop_cameras_file = "scene_camera.json";

/// The numbers of the images that the file of a scene names, in order. Throws InputError.
std::vector<int> bop_image_numbers(const std::filesystem::path& scene);

/// The camera of an image, for depth images of this size; its depth_scale, which the file has in millimetres, in
/// metres. Throws InputError naming the file and the place.
CameraFile read_bop_camera(const std::filesystem::path& scene, int number, cv::Size size);

/// "000012" of 12, as the images are named.
std::string bop_digits(int number);

}  // namespace gestalt
