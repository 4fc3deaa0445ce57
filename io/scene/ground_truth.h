// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <opencv2/core.hpp>
#include <string>

#include "gestalt/io/scene/input.h"

namespace gestalt {

/// Brings the numbers of an image of labels, of the frame's size, to the scheme of object_of_label() and puts them into
/// Input::ground_truth; what was guessed into its notes, and why it could not be into its ground_truth_problem.
/// measured: not 0 where there is depth. Pixels without depth become 0 unless the labels are of that scheme already.
/// source: the file or array, for messages.
GESTALT_EXPORT void set_ground_truth(Input& input, const cv::Mat_<int>& labels, const cv::Mat& measured,
                                     LabelScheme scheme, const std::string& source);

/// The same of what lies in a scene's folder, if anything: label.png (numbers or colours), a folder of masks (masks,
/// mask_visib or mask: one PNG for each object) or instances of COCO (coco.json, annotations.json, instances.json).
/// Throws nothing: what cannot be read is the input's ground_truth_problem.
GESTALT_EXPORT void read_ground_truth_beside(Input& input, const std::filesystem::path& folder, const cv::Mat& measured,
                                             LabelScheme scheme);

/// The ground truth of an input. Throws InputError where there is none, or its problem.
GESTALT_EXPORT const cv::Mat_<std::uint16_t>& require_ground_truth(const Input& input);

}  // namespace gestalt
