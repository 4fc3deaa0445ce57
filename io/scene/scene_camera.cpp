// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_camera.h"

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace fs = std::filesystem;

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

cv::Size size_of(const Camera& camera) { return {camera.width, camera.height}; }

std::string camera_name(const CameraFile& camera) {
  return camera.file.empty() ? "the given camera" : camera.file.string();
}

void check_size(const CameraFile& camera, cv::Size size, const fs::path& image) {
  if (size_of(camera.camera) != size)
    throw InputError(camera_name(camera) + ": is made for " + text(size_of(camera.camera)) + " images, " +
                     image.string() + " is " + text(size) + "; give the camera file of this sensor mode");
}

std::optional<CameraFile> choose_camera(const fs::path& scene, const std::optional<CameraFile>& given) {
  if (given) return given;
  const auto file = find_camera_file(scene);
  return file ? std::optional(read_camera(*file)) : std::nullopt;
}

}  // namespace gestalt
