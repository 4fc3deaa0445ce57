// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "folder_scene.h"

#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "image_frame.h"
#include "png_file.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

/// Reads an image that lies beside depth.png and must have its size.
template <class Image>
Image read_companion(const fs::path& file, Image (*read)(const fs::path&), cv::Size size) {
  Image image = read(file);
  if (image.size() != size)
    throw InputError(file.string() + ": is " + text(image.size()) + ", depth.png is " + text(size) +
                     "; register the images to one size");
  return image;
}

}  // namespace

bool is_scene_folder(const fs::path& folder) {
  std::error_code error;
  return fs::exists(folder / "depth.png", error) || fs::exists(folder / "rgb.png", error);
}

Input read_scene_folder(const fs::path& folder, const ReadOptions& options) {
  std::error_code error;
  const fs::path depth_file = folder / "depth.png", colour_file = folder / "rgb.png";
  if (!fs::exists(depth_file, error))
    throw InputError(depth_file.string() +
                     ": does not exist; a scene folder needs the depth image as 16-bit PNG under this name");
  const cv::Mat_<std::uint16_t> raw = read_depth_png(depth_file);
  const auto camera = choose_camera(folder, options.camera);
  if (!camera)
    throw InputError(folder.string() + ": has no camera.yaml, nor has a parent folder; write one or give --camera");
  if (cv::countNonZero(raw) == 0)
    throw InputError(depth_file.string() + ": no pixel has a measurement (all are 0); record the scene again");

  Input input;
  cv::Mat colour;
  if (fs::exists(colour_file, error)) colour = read_companion(colour_file, read_colour_png, raw.size());
  read_ground_truth_beside(input, folder, raw != 0, options.labels);
  set_frame_of_images(input, folder.string(), colour, depth_reading(raw, options, *camera), *camera, depth_file);
  return input;
}

}  // namespace gestalt
