// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "colour_camera.h"

#include <cmath>

#include "gestalt/core/base/error.h"
#include "number_list.h"
#include "scene_camera.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

cv::Affine3d read_extrinsics(const fs::path& file) {
  const std::vector<double> values = read_numbers(file);
  const auto fail = [&](const std::string& what) {
    throw InputError(file.string() + ": " + what +
                     "; write the 4x4 matrix, row by row, that takes points from depth's "
                     "frame to colour's, in metres");
  };
  if (values.size() != 16 && values.size() != 12) fail("has " + std::to_string(values.size()) + " numbers");
  cv::Matx44d pose = cv::Matx44d::eye();
  for (std::size_t i = 0; i < values.size(); ++i) pose.val[i] = values[i];
  const cv::Matx33d turn = pose.get_minor<3, 3>(0, 0);
  if (cv::norm(turn * turn.t() - cv::Matx33d::eye()) > 1e-2 || cv::determinant(turn) < 0)
    fail("its first three columns are not a rotation");
  if (std::hypot(pose(0, 3), pose(1, 3), pose(2, 3)) > 2)
    fail("the cameras are more than 2 m from each other");  // millimetres, most likely
  return {turn, cv::Vec3d(pose(0, 3), pose(1, 3), pose(2, 3))};
}

}  // namespace

std::optional<ColourCamera> find_colour_camera(const fs::path& folder, cv::Size size) {
  std::error_code ignored;
  for (const fs::path& name :
       {fs::path(colour_camera_name), fs::path("camera_rgb.yaml"), fs::path("intrinsic") / "intrinsic_color.txt"}) {
    const fs::path file = folder / name;
    if (!fs::is_regular_file(file, ignored)) continue;
    const CameraFile read = read_camera(file);
    if (read.lens.distorts())
      throw InputError(file.string() +
                       ": its lens distorts, but only rectified colour can be registered; rectify the images, and give "
                       "a camera without distortion");
    Input told;
    ColourCamera camera{camera_for(read, size, "the colour image", told), file, {}, {}};
    camera.extrinsics = folder / extrinsics_name;
    if (fs::is_regular_file(camera.extrinsics, ignored))
      camera.from_depth = read_extrinsics(camera.extrinsics);
    else
      camera.extrinsics.clear();
    return camera;
  }
  return std::nullopt;
}

}  // namespace gestalt
