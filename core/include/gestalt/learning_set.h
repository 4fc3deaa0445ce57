// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/classifier.h"
#include "gestalt/pipeline.h"

namespace gestalt {

/// Ground truth of a pixel in a label image (OSD convention): 0 ignored, 1-9 background, 20-29 parts of the first
/// object, 30-39 of the second, ... Gives 0 ignored, 1 background, 2 and up an object.
inline int object_of_label(int label) { return label < 10 ? (label > 0 ? 1 : 0) : label / 10; }

/// Majority object over the pixels of every surface that have ground truth: 0 none, 1 background, >= 2 object.
/// Ties go to the smaller number.
GESTALT_EXPORT std::vector<int> surface_objects(const SurfaceSet& surfaces,
                                                const cv::Mat_<std::uint16_t>& ground_truth);

/// Appends the labelled pairs of one scene (paper, Section 5): positive when both surfaces belong to one object,
/// negative when to two, or to an object and background. Pairs of two background surfaces, or with a surface without
/// ground truth, are no samples.
GESTALT_EXPORT void append_pairs(const Percept& percept, const cv::Mat_<std::uint16_t>& ground_truth, Samples& samples);

}  // namespace gestalt
