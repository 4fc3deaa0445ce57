// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <map>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "gestalt/core/base/output_file.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

// Writing scenes as gestalt reads them; docs/formats.md describes the files.

/// The images of a scene folder, all of one size.
struct SceneImages {
  cv::Mat colour;                 ///< CV_8UC3, blue green red; empty: no rgb.png
  cv::Mat_<std::uint16_t> depth;  ///< millimetres, or units of depth_scale; 0 = no measurement
  cv::Mat_<std::uint16_t> label;  ///< see object_of_label(); empty: no label.png
};

/// Depth of a frame in whole units of so many metres. Throws InputError when a depth is more than 65535 of them.
GESTALT_EXPORT cv::Mat_<std::uint16_t> depth_in_units(const Frame& frame, double metres);

/// The same in millimetres.
GESTALT_EXPORT cv::Mat_<std::uint16_t> depth_in_millimetres(const Frame& frame);

/// Writes folder/{rgb,label,depth}.png and other files of the scene, all or none. Throws OutputError.
GESTALT_EXPORT void write_scene_folder(const OutputPath& folder, const SceneImages& images,
                                       std::vector<OutputFile> others = {});

/// The same with folder/camera.yaml. depth_scale: metres for each unit of the depth image, in [1e-6, 1].
GESTALT_EXPORT void write_scene_folder(const OutputPath& folder, const SceneImages& images, const Camera& camera,
                                       double depth_scale = 0.001);

/// Writes folder/camera.yaml for the scenes of the folder. Throws OutputError when it exists with other intrinsics.
GESTALT_EXPORT void write_camera(const Camera& camera, const OutputPath& folder);

/// Enters the categories of scenes into the table `scene,category`, keeping the rows of other scenes; rows are in
/// the order of the scenes' names. Makes the file where it does not exist. Throws InputError, with the line, for a
/// file that is not such a table and OutputError when it cannot be written.
GESTALT_EXPORT void merge_categories(const OutputPath& file,
                                     const std::map<std::string, std::string>& category_of_scene);

}  // namespace gestalt
