// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "layout.h"

namespace gestalt::synthesis {

/// What a perfect sensor sees, pixel by pixel.
struct IdealView {
  static constexpr int nothing = -1;          ///< floor, wall or sky, beyond what is measured
  static constexpr int table = 0;             ///< things are 1, 2, ... in the order of the arrangement
  static constexpr int first_furniture = -2;  ///< further pieces are -3, -4, ... in the order of the arrangement

  cv::Mat_<cv::Vec3f> colour;  ///< 0-255, blue green red, without noise and blur
  cv::Mat_<int> body;          ///< nothing, table or the number of the thing or piece of furniture
  cv::Mat_<float> depth;       ///< metres along the optical axis; 0 where there is nothing
  cv::Mat_<float> slant;       ///< cosine between the surface's normal and the ray, 0-1; 0 where there is nothing
  cv::Mat_<uchar> measurable;  ///< 1 where the depth sensor's camera and its projector both see the surface
};

/// measurable is for this sensor.
IdealView render(const Arrangement& arrangement, SensorModel sensor = SensorModel::structured_light);

}  // namespace gestalt::synthesis
