// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>

#include "gestalt/core/scene/frame.h"
#include "point_cloud.h"

namespace gestalt {

/// From the frame that the points of a cloud are in to the camera's: rotation * point + translation, where a mirrored
/// cloud has a reflection for its rotation.
struct FrameChange {
  cv::Matx33d rotation = cv::Matx33d::eye();
  cv::Vec3d translation;
  std::string name;  ///< of the frame that they are in, for messages

  PointCloud operator()(PointCloud cloud) const;
};

/// The frame in which a pinhole camera sees the points of an organized cloud in their pixels, to within
/// largest_reprojection_error (median): the given camera, or any that looks forward. One of axes that are permuted,
/// turned or mirrored, that of VIEWPOINT, or, by solving the projection, any other. Nothing when there is none, or
/// the points do not tell (those of a plane tell no frame beyond the first two kinds).
std::optional<FrameChange> frame_of_organized(const PointCloud& cloud, const std::optional<Camera>& camera);

/// The frame in which the camera sees the points of an unorganized cloud: one of the frames that programs use, or that
/// of VIEWPOINT, if nearly all of them lie in its image then. Nothing when there is none.
std::optional<FrameChange> frame_of_unorganized(const PointCloud& cloud, const Camera& camera);

/// The same without a camera: all points lie before it, in a field of view that cameras have.
std::optional<FrameChange> frame_of_unorganized(const PointCloud& cloud);

/// Whether at least half of the points that a sensor measured lie before the camera (z > 0).
bool mostly_visible(const PointCloud& cloud);

/// Share of the points with finite coordinates that lie in the image of the camera; 0 without any.
double share_in_image(const PointCloud& cloud, const Camera& camera);

}  // namespace gestalt
