// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "image_frame.h"

#include <cmath>

#include "gestalt/core/base/error.h"
#include "rectification.h"
#include "scene_camera.h"

namespace gestalt {

namespace {

constexpr double harmless = 0.01;  // of the image's radius

std::string pixels(double shift) {
  return std::to_string(std::lround(10 * shift) / 10) + "." + std::to_string(std::lround(10 * shift) % 10) + " px";
}

}  // namespace

void set_frame_of_images(Input& input, const std::string& name, const cv::Mat& colour, DepthReading depth,
                         const CameraFile& file, const std::filesystem::path& image) {
  const Camera camera = camera_for(file, depth.metres.size(), image, input);
  const double shift = largest_shift(file.lens, camera), radius = std::hypot(camera.width, camera.height) / 2;
  if (shift == 0) return set_frame(input, name, colour, std::move(depth), camera);
  if (shift < harmless * radius) {
    input.warnings.push_back(camera_name(file) + ": its lens moves pixels by up to " + pixels(shift) +
                             ", which is ignored; rectify the images if that is too much");
    return set_frame(input, name, colour, std::move(depth), camera);
  }
  if (std::isfinite(shift) && shift > 2 * radius)
    throw InputError(camera_name(file) + ": its lens moves pixels by up to " + pixels(shift) + ", farther than the " +
                     "image is wide and high; correct its coefficients, or leave them out if the images are rectified");
  const Rectification rectified(file.lens, camera);
  depth.metres = rectified(depth.metres);
  if (!input.ground_truth.empty()) input.ground_truth = rectified(input.ground_truth);
  input.notes.push_back(camera_name(file) + ": its lens moves pixels by " +
                        (std::isfinite(shift) ? "up to " + pixels(shift) : std::string("more than it can tell")) +
                        "; the images are rectified, and results refer to the rectified images. If the images are "
                        "already rectified, give a camera without distortion");
  set_frame(input, name, rectified(colour), std::move(depth), camera);
}

}  // namespace gestalt
