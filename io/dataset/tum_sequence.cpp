// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/dataset/tum_sequence.h"

#include "gestalt/io/scene/associations.h"
#include "image_set.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

// What the benchmark's page says of its files: the factory's camera, and 5000 units a metre.
constexpr Camera tum_camera{640, 480, 525, 525, 319.5, 239.5};
constexpr double tum_depth_scale = 1.0 / 5000;

/// In units of the benchmark; other recordings in its layout are often in millimetres.
bool nearer_than_a_kinect_sees(const cv::Mat_<std::uint16_t>& depth) {
  constexpr double nearest = 0.35 / tum_depth_scale;
  return cv::countNonZero((depth > 0) & (depth < nearest)) > cv::countNonZero(depth) / 2;
}

}  // namespace

std::vector<FrameFiles> find_tum_frames(const fs::path& sequence) { return associated_images(sequence); }

ConvertedScene read_tum_frame(const FrameFiles& frame, const ReadOptions& given) {
  ReadOptions options = given;
  if (const auto found = find_camera_file(frame.depth); found && !options.camera) options.camera = read_camera(*found);
  const LayoutImages images = read_images(frame.depth, frame.colour);
  const CameraFile camera = camera_of_layout(tum_camera, images.depth.size(), frame.depth, options);
  ConvertedScene scene = scene_of(images, camera, tum_depth_scale, frame.depth, options);
  if (scene.depth_scale == tum_depth_scale && !options.depth_scale && nearer_than_a_kinect_sees(scene.images.depth))
    scene.warnings.push_back(frame.depth.string() +
                             ": half of its depth is nearer than 0.35 m when read with the benchmark's 5000 units per "
                             "metre, too near for its sensors; if it is in millimetres, give --unit mm");
  return scene;
}

}  // namespace gestalt
