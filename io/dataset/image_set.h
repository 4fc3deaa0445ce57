// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "gestalt/core/scene/frame.h"
#include "gestalt/io/scene/converted_scene.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_folder.h"

namespace gestalt {

/// The images of a scene in a layout, with what is to be noted of their files.
struct LayoutImages : SceneImages {
  std::vector<std::string> notes;
};

/// Depth without what stands for "no measurement" (65535), and colour where a file is named, of one size.
/// Throws InputError naming the file and the remedy.
LayoutImages read_images(const std::filesystem::path& depth, const std::filesystem::path& colour);

/// The camera that the options give; else that of the layout, for images of its size: of others it is not known whether
/// they are scaled or cut. Throws InputError naming the file of depth.
CameraFile camera_of_layout(const Camera& camera, cv::Size size, const std::filesystem::path& depth,
                            const ReadOptions& options);

/// The scene of such images, made as frames of their camera are (set_frame_of_images()): the camera is scaled to them,
/// they are rectified where its lens distorts, depth is questioned and stays in its unit. That is what the options
/// tell, else the camera, else the layout.
ConvertedScene scene_of(const LayoutImages& images, CameraFile camera, double scale_of_layout,
                        const std::filesystem::path& depth, const ReadOptions& options);

/// An image of labels of the same size as depth, as it is.
cv::Mat_<std::uint16_t> read_labels(const std::filesystem::path& file, cv::Size size);

/// The PNG files of a folder, in natural order. Throws InputError when it cannot be listed or has none.
std::vector<std::filesystem::path> png_files(const std::filesystem::path& folder);

/// Labels of ours (1 background, 20 the first object, 30 the second, ...) for those that count objects; 0 where depth
/// is 0. Images of one size. Throws InputError for more than 6552 objects, our labels are of 16 bits.
cv::Mat_<std::uint16_t> labels_of_objects(const cv::Mat_<std::uint16_t>& objects, const cv::Mat_<std::uint16_t>& depth);

/// The same, naming the file of the annotation in messages.
cv::Mat_<std::uint16_t> labels_from(const std::filesystem::path& annotation, const cv::Mat_<std::uint16_t>& objects,
                                    const cv::Mat_<std::uint16_t>& depth);

}  // namespace gestalt
