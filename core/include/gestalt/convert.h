// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "gestalt/input.h"
#include "gestalt/scene_folder.h"

namespace gestalt {

// Data of other layouts as scenes of ours. The Object Segmentation Database (OSD 0.2, Richtsfeld et al.) comes as
// image_color/NAME.png, disparity/NAME.png, annotation/NAME.png and pcd/NAME.pcd, NAME being learn0..44 or test0..65.

/// What the labels of other data count.
enum class LabelKind {
  parts,   ///< as ours do: object_of_label()
  objects  ///< 0 what is no object, 1 the first object, 2 the second, ... (OSD 0.2)
};

/// A scene ready to be written.
struct ConvertedScene {
  SceneImages images;
  Camera camera;
  int objects = 0;  ///< with at least one pixel that has depth
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
