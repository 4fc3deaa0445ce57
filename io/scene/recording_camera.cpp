// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "recording_camera.h"

#include <array>

#include "assignments.h"
#include "bop_cameras.h"
#include "frame_files.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"

namespace gestalt {

namespace fs = std::filesystem;

namespace {

// Depth's own before those that may be the colour camera's.
constexpr std::array<const char*, 17> names{"camera.yaml",
                                            "intrinsic/intrinsic_depth.txt",
                                            "intrinsic_depth.txt",
                                            "depth_intrinsics.txt",
                                            "cam_K.txt",
                                            "K.txt",
                                            "intrinsics.txt",
                                            "intrinsic.txt",
                                            "camera-intrinsics.txt",
                                            "camera_intrinsics.txt",
                                            "camera_intrinsic.json",
                                            "camera_intrinsics.json",
                                            "intrinsic.json",
                                            "intrinsics.json",
                                            "camera.json",
                                            "camera_info.yaml",
                                            "_info.txt"};

/// The number of a BOP image by its name; -1: it is none.
int bop_number(const fs::path& depth) {
  const std::string stem = depth.stem().string();
  return stem.empty() || stem.size() > 6 || stem.find_first_not_of("0123456789") != stem.npos ? -1 : std::stoi(stem);
}

bool has_assignments(const fs::path& file) {
  constexpr std::uintmax_t longest = 1 << 16;
  std::error_code ignored;
  return fs::is_regular_file(file, ignored) && fs::file_size(file, ignored) <= longest &&
         is_assignments(read_bytes(file, longest));
}

}  // namespace

std::optional<fs::path> camera_file_of_frame(const fs::path& depth, const fs::path& recording) {
  std::error_code ignored;
  if (fs::is_regular_file(recording / bop_cameras_file, ignored) && bop_number(depth) >= 0)
    return recording / bop_cameras_file;
  // That of 7-Scenes and of BundleFusion lies above all sequences.
  const fs::path place = fs::absolute(recording, ignored).lexically_normal();
  const fs::path own = place.has_filename() ? place : place.parent_path();
  for (const fs::path& folder : {recording, own.parent_path()})
    for (const char* name : names)
      if (fs::is_regular_file(folder / name, ignored)) return folder / name;
  // ScanNet's scan scene0000_00 has its text in scene0000_00.txt.
  if (const fs::path text = recording / (own.filename().string() + ".txt"); has_assignments(text)) return text;
  return find_camera_file(depth);
}

CameraFile camera_of_frame(const fs::path& depth, const fs::path& recording, cv::Size size, const ReadOptions& options,
                           std::vector<std::string>& warnings) {
  if (options.camera) return *options.camera;
  std::error_code ignored;
  if (const auto file = camera_file_of_frame(depth, recording))
    return file->filename() == bop_cameras_file ? read_bop_camera(recording, bop_number(depth), size)
                                                : read_camera(*file);
  if (size == cv::Size(640, 480) && fs::exists(recording / "rgb.txt", ignored) &&
      fs::exists(recording / "depth.txt", ignored)) {
    warnings.push_back(recording.string() +
                       ": has no camera; assumed to be a TUM sequence: 525 px, 5000 units of depth per metre. If it is "
                       "not, give --camera FILE and --unit");
    CameraFile camera(Camera{640, 480, 525, 525, 319.5, 239.5});
    camera.depth_scale = 1.0 / 5000;
    return camera;
  }
  throw InputError(depth.string() + ": has no camera (" + seen_in(recording) + " in " + recording.string() +
                   "); give --camera FILE, or --fx, --fy, --cx and --cy, or write camera.yaml there: width, "
                   "height, fx, fy, cx, cy");
}

}  // namespace gestalt
