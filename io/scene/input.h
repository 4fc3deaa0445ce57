// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gestalt/core/scene/frame.h"
#include "gestalt/io/scene/lens.h"

namespace gestalt {

/// What a camera file says.
struct CameraFile {
  CameraFile() = default;
  /// Implicit, so that intrinsics made in memory can be given where a camera file can.
  CameraFile(const Camera& intrinsics) : camera(intrinsics) {}  // NOLINT(google-explicit-constructor)

  Camera camera;                      ///< width and height may be 0: those of the images
  std::optional<double> depth_scale;  ///< metres per unit of depth in whole numbers, in [1e-6, 1]; nothing: not told
  std::filesystem::path file;         ///< where it was read; empty when made in memory
  Lens lens{};                        ///< of a camera that is not a pinhole; camera is its matrix
  std::vector<std::string> notes{};   ///< what was guessed as it was read
};

/// Reads intrinsics as people have them, in any of the formats of docs/formats.md: width, height, fx, fy, cx, cy
/// (pixels) and, where present, depth_scale in YAML; what ROS, OpenCV, Open3D, RealSense, COLMAP, kalibr and others
/// write. Throws InputError with all errors of the file together, each `file:line:column: message`, counted from 1.
GESTALT_EXPORT CameraFile read_camera(const std::filesystem::path& file);

/// What the numbers of a depth image or array say.
enum class DepthKind {
  plain,   ///< depth along the optical axis
  radial,  ///< distance from the camera's centre
  rotated  ///< depth of 16 bits, rotated left by three (SUN RGB-D)
};

/// What the numbers of ground truth say.
enum class LabelScheme {
  guess,    ///< what they can only be; refused where that is not certain and ground truth is needed
  osd,      ///< object_of_label(): 0 ignored, 1 to 9 background, 20 to 29 the first object, ...
  objects,  ///< 0 background, every other number an object
  colours   ///< the commonest colour is background, every other an object
};

/// What the user says about scenes. It overrides everything in their files.
struct ReadOptions {
  ReadOptions() = default;
  /// Implicit, so that a camera can be given where options can.
  ReadOptions(std::optional<CameraFile> given) : camera(std::move(given)) {}  // NOLINT(google-explicit-constructor)
  ReadOptions(const CameraFile& given) : camera(given) {}                     // NOLINT(google-explicit-constructor)
  ReadOptions(const Camera& intrinsics) : camera(CameraFile(intrinsics)) {}   // NOLINT(google-explicit-constructor)

  std::optional<CameraFile> camera;  ///< in place of the scene's own, its depth_scale included
  std::optional<double>
      depth_scale;  ///< metres per unit of every depth and cloud, whole numbers or not, in [1e-9, 1e4]
  DepthKind depth_kind = DepthKind::plain;
  LabelScheme labels = LabelScheme::guess;
  std::filesystem::path colour;  ///< image of a scene that is one file, in place of what would be found
};

/// Depth in metres, each the float that is nearest to raw * scale; scale as CameraFile::depth_scale.
GESTALT_EXPORT cv::Mat_<float> depth_in_metres(const cv::Mat_<std::uint16_t>& raw, double scale);

/// The camera.yaml that belongs to a scene: in the scene folder, or the folder that holds the cloud, or its nearest
/// parent (as the path is written: symbolic links are not resolved). Nothing when there is none.
GESTALT_EXPORT std::optional<std::filesystem::path> find_camera_file(const std::filesystem::path& scene);

/// One scene as read from disk.
struct Input {
  std::filesystem::path path;            ///< the scene folder or the cloud file, as given
  Frame frame;                           ///< named as scene_name()
  cv::Mat_<std::uint16_t> ground_truth;  ///< label.png or the cloud's label field (see object_of_label()); else empty
  std::vector<cv::Vec3f> cloud;          ///< unorganized clouds only: the original points, metres, as they were read
  std::vector<int> point_pixels;         ///< unorganized clouds only: the pixel of each original point (also of those
                                         ///< hidden behind a nearer one), -1 = outside the image, behind the camera or
                                         ///< without a finite position
  std::string depth_unit;                ///< of the file's numbers and who tells it: "0.001 m, the default"
  std::string camera_from;               ///< the file, or what else tells the camera; "" where it was not noted
  std::string colour_from;               ///< the file, where colour is an image of its own; else ""
  std::vector<std::string> warnings;     ///< what is probably not as it was read; each names its file
  std::vector<std::string> notes;        ///< what was taken for certain though no file tells it; without its file
  std::string ground_truth_problem;      ///< why the labels that are there are not in ground_truth; empty: nothing
};

/// The name of a scene in results: the folder's name, or the cloud's without extension. It names an entry of a folder:
/// throws InputError where it would be '.' or '..'.
GESTALT_EXPORT std::string scene_name(const std::filesystem::path& scene);

/// Every scene below the given paths, in the given order, the scenes of a folder in natural order (learn2 before
/// learn10). A path is a scene of one of scene_formats(), or a folder of those; other files in a folder are left out. A
/// folder with depth.png or rgb.png counts as a scene, so that one that lacks its depth is reported when it
/// is read, not lost. Throws InputError for a path that does not exist or holds no scene, and for two scenes of the
/// same name.
GESTALT_EXPORT std::vector<std::filesystem::path> find_scenes(const std::vector<std::filesystem::path>& paths);

/// Reads a scene of any of scene_formats() (docs/formats.md). The camera is that of the options, else that of
/// find_camera_file(); an organized cloud without either gets intrinsics fitted to its points. A cloud is unorganized
/// when its height is 1 and the camera does not have just its size: then each point goes to its nearest pixel, the
/// nearest point of a pixel wins. Throws InputError, which names the file, the place and the remedy, for everything
/// that cannot be used. Thread-safe; prints nothing.
GESTALT_EXPORT Input read_scene(const std::filesystem::path& path, const ReadOptions& options = {});

}  // namespace gestalt
