// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <optional>
#include <vector>

namespace gestalt {

/// A point and the pixel (column, row) in which an organized cloud stores it.
struct StoredPoint {
  cv::Vec3f point;
  cv::Point2d pixel;
};

/// The pose of a pinhole camera: camera = rotation * point + translation.
struct CameraPose {
  cv::Matx33d rotation;  ///< orthogonal; a reflection where the points are mirrored
  cv::Vec3d translation;
};

/// The pose of the camera that sees each point in its pixel, by direct linear transformation. As the points lie on
/// their rays whatever the noise of depth, they solve it exactly. Nothing when they do not determine it, as those of a
/// plane, or no pinhole with square axes does.
std::optional<CameraPose> solve_projection(const std::vector<StoredPoint>& points);

}  // namespace gestalt
