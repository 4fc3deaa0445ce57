// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_scene.h"

#include "colour_camera.h"
#include "colour_image.h"
#include "colour_registration.h"
#include "gestalt/core/base/error.h"
#include "gestalt/io/scene/depth_reading.h"
#include "gestalt/io/scene/ground_truth.h"
#include "gestalt/io/scene/image_file.h"
#include "image_frame.h"
#include "recording_camera.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

DepthReading reading_of(const cv::Mat& image, const fs::path& file, const ReadOptions& options,
                        const CameraFile& camera) {
  if (image.type() == CV_32FC1) return float_reading(image, options);
  if (cv::countNonZero(image) == 0)
    throw InputError(file.string() + ": no pixel has a measurement (all are 0); record the scene again");
  return depth_reading(image, options, camera);
}

/// Colour of depth's size.
cv::Mat read_colour(const FrameFiles& files, const fs::path& folder, const DepthReading& depth,
                    const CameraFile& camera, Input& input) {
  const cv::Mat colour = read_colour_image(files.colour, input.notes);
  const cv::Size size = depth.metres.size();
  if (colour.size() == size) return colour;
  const std::string sizes = files.colour.string() + ": is " + text(colour.size()) + ", " +
                            files.depth.filename().string() + " is " + text(size);
  if (const auto second = find_colour_camera(folder, colour.size())) {
    input.warnings.push_back(sizes + "; registered by " + second->file.string() +
                             (second->extrinsics.empty() ? ", assuming that both cameras are in the same place"
                                                         : " and " + second->extrinsics.string()));
    Input told;  // by set_frame_of_images()
    return registered_colour(colour, second->intrinsics, second->from_depth, depth.metres,
                             camera_for(camera, size, files.depth, told));
  }
  if (same_aspect(colour.size(), size)) {
    input.warnings.push_back(
        sizes + "; assumed to show the same view and resampled. If the cameras are not registered, write " +
        "the colour camera's intrinsics as " + (folder / colour_camera_name).string());
    return resized(colour, size);
  }
  throw InputError(sizes +
                   ", so the two cameras do not show the same view; register one to the other with the "
                   "sensor's software, or write the colour camera's intrinsics as " +
                   (folder / colour_camera_name).string() +
                   " (and the 4x4 matrix from depth's frame "
                   "to colour's, in metres, as " +
                   extrinsics_name + "), or remove the colour image to segment by depth alone");
}

}  // namespace

bool is_frame(const fs::path& path) {
  std::error_code ignored;
  return has_image_extension(path) && fs::is_regular_file(path, ignored);
}

Input read_frame_scene(const fs::path& depth, const ReadOptions& options) {
  FrameFiles files{depth, options.colour};
  if (files.colour.empty()) files = files_of_frame(depth);
  return read_frame_files(files, recording_of(depth), depth, options, GroundTruth::none);
}

Input read_frame_files(const FrameFiles& files, const fs::path& folder, const fs::path& name,
                       const ReadOptions& options, GroundTruth ground_truth) {
  Input input;
  const cv::Mat image = read_depth_image(files.depth);
  const CameraFile camera = camera_of_frame(files.depth, folder, image.size(), options, input.warnings);
  DepthReading depth = reading_of(image, files.depth, options, camera);
  input.camera_from = camera_name(camera);
  input.colour_from = files.colour.string();
  cv::Mat colour;
  if (!files.colour.empty()) colour = read_colour(files, folder, depth, camera, input);
  if (ground_truth == GroundTruth::beside) read_ground_truth_beside(input, folder, depth.metres > 0, options.labels);
  set_frame_of_images(input, name.string(), colour, std::move(depth), camera, files.depth);
  return input;
}

}  // namespace gestalt
