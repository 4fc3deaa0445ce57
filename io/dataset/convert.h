// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"

namespace gestalt {

// Data of other layouts as scenes of ours. The Object Segmentation Database (OSD 0.2, Richtsfeld et al.) comes as
// image_color/NAME.png, disparity/NAME.png, annotation/NAME.png and pcd/NAME.pcd, NAME being learn0..44 or test0..65.

/// What the labels of other data count.
enum class LabelKind {
  parts,   ///< as ours do: object_of_label()
  objects  ///< 0 what is no object, 1 the first object, 2 the second, ... (OSD 0.2)
};

/// The names of all scenes of an original OSD release, in natural order: every PNG of its three folders, so that a
/// scene that lacks one of its images is reported when it is read. Throws InputError for a folder without them.
GESTALT_EXPORT std::vector<std::string> find_osd_scenes(const std::filesystem::path& release);

/// Reads one scene of an OSD release. disparity/ holds depth along the optical axis in millimetres, despite its name.
/// camera: else the database's (525 px, 640x480); its depth_scale is not used. Throws InputError naming the file and
/// the remedy.
GESTALT_EXPORT ConvertedScene read_osd_scene(const std::filesystem::path& release, const std::string& name,
                                             const std::optional<CameraFile>& camera = std::nullopt);

/// Reads a PCD file with labels as read_scene() does; its colour may be missing. Throws InputError, also for labels
/// that name no object.
GESTALT_EXPORT ConvertedScene read_labelled_cloud(const std::filesystem::path& file, LabelKind labels,
                                                  const std::optional<CameraFile>& camera = std::nullopt);

/// A frame of a sequence of the TUM RGB-D benchmark.
struct TumFrame {
  std::filesystem::path depth;
  std::filesystem::path colour;
};

/// The frames of a sequence, by rgb.txt and depth.txt, in order of time: the images that are nearest in time go
/// together, at most 0.02 s apart, each in one frame. Throws InputError with the line.
GESTALT_EXPORT std::vector<TumFrame> find_tum_frames(const std::filesystem::path& sequence);

/// Depth has 5000 units a metre. camera: else the factory's of a Kinect (525 px, 640x480), as the benchmark advises.
GESTALT_EXPORT ConvertedScene read_tum_frame(const TumFrame& frame,
                                             const std::optional<CameraFile>& camera = std::nullopt);

/// An image of a scene in the layout of BOP, the benchmark for 6D object pose estimation.
struct BopImage {
  std::filesystem::path scene;
  int number = 0;
  std::filesystem::path depth;
};

/// All images of a scene, or of all scenes in a folder, that scene_camera.json names. Throws InputError.
GESTALT_EXPORT std::vector<BopImage> find_bop_images(const std::filesystem::path& folder);

/// "000001_000012": scene and image.
GESTALT_EXPORT std::string bop_name(const BopImage& image);

/// Camera and scale of depth from scene_camera.json; objects from mask_visib, where there are masks, everything else is
/// background. Throws InputError naming the file and the place.
GESTALT_EXPORT ConvertedScene read_bop_image(const BopImage& image,
                                             const std::optional<CameraFile>& camera = std::nullopt);

/// A frame of the Object Cluttered Indoor Dataset (OCID).
struct OcidFrame {
  std::filesystem::path sequence;
  std::filesystem::path depth;
  std::string name;  ///< the way to the sequence, and that of the image
};

/// The frames of all sequences in a folder: folders that hold depth and label. Throws InputError.
GESTALT_EXPORT std::vector<OcidFrame> find_ocid_frames(const std::filesystem::path& release);

/// Depth is in millimetres. Labels 0 and 1 are background, as is 2 where "table" is in the path of the sequence; the
/// others are objects. camera: else that of the points in pcd/. Throws InputError.
GESTALT_EXPORT ConvertedScene read_ocid_frame(const OcidFrame& frame,
                                              const std::optional<CameraFile>& camera = std::nullopt);

/// Labels of ours (1 background, 20 the first object, 30 the second, ...) for those that count objects; 0 where depth
/// is 0. Images of one size. Throws InputError for more than 6552 objects, our labels are of 16 bits.
GESTALT_EXPORT cv::Mat_<std::uint16_t> labels_of_objects(const cv::Mat_<std::uint16_t>& objects,
                                                         const cv::Mat_<std::uint16_t>& depth);

/// What the database's readme says of a scene's name, learnN or testN.
struct OsdScene {
  std::string set;       ///< "learn" or "test"; "scenes" for any other name
  std::string category;  ///< "boxes", ..., "complex_scene"; "" for any other name
};
GESTALT_EXPORT OsdScene osd_scene(std::string_view name);

}  // namespace gestalt
