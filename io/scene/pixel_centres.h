// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// A pixel's point lies anywhere in the pixel, but its depth is taken for that of the pixel's centre, by which slanted
/// surfaces become rough. Gives the depth that the plane through the points of the pixel and its neighbours, where
/// these are of one surface, has in the centre. Depths stay as they are where the points lie in the centres, as those
/// of a sensor do in its own camera. point_of_pixel: index into points, -1 where there is none; row by row.
cv::Mat_<float> depth_in_centres(const cv::Mat_<float>& depth, const std::vector<int>& point_of_pixel,
                                 const std::vector<cv::Vec3f>& points, const Camera& camera);

}  // namespace gestalt
