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

/// Depth, and colour where a file is named, of the camera's size; one that tells none gets that of the images.
/// Throws InputError naming the file and the remedy.
SceneImages read_images(const std::filesystem::path& depth, const std::filesystem::path& colour, Camera& camera);

/// Metres per unit of depth: what the options tell, by themselves or by their camera, else what the layout has.
double scale_of(const ReadOptions& options, double of_layout);

/// Asks whether the depth of a scene, whose depth_scale is set, can be what it was read as (question_depth()).
void question(ConvertedScene& scene, const std::filesystem::path& depth, const ReadOptions& options);

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
