// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <vector>

#include "gestalt/core/scene/frame.h"
#include "point_cloud.h"
#include "projection_solution.h"

namespace gestalt {

/// Pixels: a camera whose median_reprojection_error() is larger does not belong to the cloud.
inline constexpr double largest_reprojection_error = 1;

/// The intrinsics under which the visible points of an organized cloud lie in their pixels: least squares of
/// u = fx x / z + cx and v = fy y / z + cy. Nothing when they do not determine them (no two columns or rows with
/// different directions). Whether a camera is like that is another question.
std::optional<Camera> fitted_camera(const PointCloud& cloud);
/// The same of some of its points; size is that of the cloud.
std::optional<Camera> fitted_camera(const std::vector<StoredPoint>& points, cv::Size size);

/// Whether its focal lengths are positive and its principal point lies in the image.
bool looks_forward(const Camera& camera);

/// Median distance in pixels between where the camera sees the visible points of an organized cloud and the pixels
/// they are stored in; 0 when no point is visible.
double median_reprojection_error(const PointCloud& cloud, const Camera& camera);
double median_reprojection_error(const std::vector<StoredPoint>& points, const Camera& camera);

/// Row-major index of the pixel that a point before the camera is seen in, -1 when it is not seen.
int pixel_of(const cv::Vec3f& point, const Camera& camera);

}  // namespace gestalt
