// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>

#include "gestalt/core/scene/frame.h"
#include "point_cloud.h"

namespace gestalt {

/// Pixels: a camera whose median_reprojection_error() is larger does not belong to the cloud.
inline constexpr double largest_reprojection_error = 1;

/// The intrinsics under which the points of an organized cloud lie in their pixels: least squares of
/// u = fx x / z + cx and v = fy y / z + cy over the visible points. Throws InputError when the points do not determine
/// them (no two columns or rows with different directions), or no pinhole camera describes them (median error
/// above largest_reprojection_error). file is for messages.
Camera fit_camera(const std::filesystem::path& file, const PointCloud& cloud);

/// Median distance in pixels between where the camera sees the visible points of an organized cloud and the pixels
/// they are stored in; 0 when no point is visible.
double median_reprojection_error(const PointCloud& cloud, const Camera& camera);

}  // namespace gestalt
