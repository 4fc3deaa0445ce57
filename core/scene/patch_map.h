// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

namespace gestalt {

/// Result of the signal level: every pixel's patch and normal. Made by a Clusterer.
struct PatchMap {
  cv::Mat_<int> labels;         ///< size of the frame; 0 = no patch, else 1..count, every label in use
  cv::Mat_<cv::Vec3f> normals;  ///< unit, towards the camera (n . p < 0); (0, 0, 0) where there is none
  int count = 0;
  std::vector<int> cut_from{};  ///< by label - 1: patches of the same number here are parts of one surface that colour
                                ///< cut, and the primitive level does not merge them again; empty: nothing was cut
};

}  // namespace gestalt
