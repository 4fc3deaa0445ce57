// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/io/scene/lens.h"

namespace gestalt {

/// Takes images to those that a camera without the lens, of the same intrinsics, would have made.
class Rectification {
 public:
  Rectification(const Lens& lens, const Camera& camera);

  /// Each pixel is the one that its ray is seen in, 0 where there is none: the nearest, as depth and labels must not be
  /// mixed. Depth along the optical axis stays what it is. An image of any type, of the camera's size; an empty one
  /// stays empty.
  cv::Mat operator()(const cv::Mat& image) const;

 private:
  cv::Mat_<int> seen_in_;  ///< row-major index of the pixel; -1: none
};

}  // namespace gestalt
