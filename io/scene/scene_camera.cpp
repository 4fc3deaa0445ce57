// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "scene_camera.h"

#include <algorithm>
#include <cmath>
#include <locale>
#include <sstream>

#include "gestalt/core/base/error.h"
#include "virtual_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Without zeros at the end.
std::string plain(double number) {
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text << number;
  return text.str();
}

}  // namespace

std::string text(cv::Size size) { return std::to_string(size.width) + "x" + std::to_string(size.height); }

cv::Size size_of(const Camera& camera) { return {camera.width, camera.height}; }

std::string camera_name(const CameraFile& camera) {
  return camera.file.empty() ? "the given camera" : camera.file.string();
}

Camera camera_for(const CameraFile& file, cv::Size size, const fs::path& image, Input& input) {
  constexpr double largest_scale = 16;  // beyond, it is another sensor's
  constexpr int smallest_side = 16;     // below, most aspects are equal
  const std::string name = camera_name(file);
  for (const std::string& note : file.notes) input.notes.push_back(name + ": " + note);
  Camera camera = file.camera;
  if (camera.width == 0 || camera.height == 0) {
    camera.width = size.width, camera.height = size.height;
    const std::string centre = name + ": its principal point (" + plain(camera.cx) + ", " + plain(camera.cy) + ") ";
    const std::string remedy =
        "; if the camera is for another resolution, add its width and height so that it is scaled";
    if (!(camera.cx >= 0 && camera.cx <= size.width && camera.cy >= 0 && camera.cy <= size.height))
      throw InputError(centre + "lies outside of " + image.string() + ", which is " + text(size) + remedy);
    // That of a camera of twice the resolution is in the corner.
    const double off = std::max(std::abs(camera.cx / size.width - 0.5), std::abs(camera.cy / size.height - 0.5));
    if (off > 0.2)
      input.warnings.push_back(centre + "is far from the middle of " + image.string() + " (" + text(size) + ")" +
                               remedy);
    return camera;
  }
  if (size_of(camera) == size) return camera;
  const double x = double(size.width) / camera.width, y = double(size.height) / camera.height;
  const int least = std::min({size.width, size.height, camera.width, camera.height});
  const bool same_aspect = std::abs(x / y - 1) <= 1.0 / least;  // sides are whole numbers: one may be off by a pixel
  if (!same_aspect || std::max(x, 1 / x) > largest_scale || least < smallest_side)
    throw InputError(name + ": is for " + text(size_of(camera)) + " images, " + image.string() + " is " + text(size) +
                     "; give the camera file of this sensor mode");
  input.notes.push_back(name + " is for " + text(size_of(camera)) + " images; it is scaled to " + text(size) +
                        ", which is right unless the images are cropped");
  return scaled(camera, size);
}

void question_pixels(const std::string& name, const Camera& camera, std::vector<std::string>& warnings) {
  constexpr double longest = 1.5;  // of a pixel's sides; an image stretched from 4:3 to 16:9 has 1.33
  const double ratio = camera.fx / camera.fy;
  if (ratio <= longest && ratio >= 1 / longest) return;
  warnings.push_back(name + ": focal lengths fx " + plain(camera.fx) + " and fy " + plain(camera.fy) +
                     " make each pixel " + plain(std::max(ratio, 1 / ratio)) + " times as " +
                     (ratio > 1 ? "high as wide" : "wide as high") + "; check both in the camera file");
}

std::optional<CameraFile> choose_camera(const fs::path& scene, const std::optional<CameraFile>& given) {
  if (given) return given;
  const auto file = find_camera_file(scene);
  return file ? std::optional(read_camera(*file)) : std::nullopt;
}

}  // namespace gestalt
