// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "gestalt/core/scene/frame.h"
#include "point_cloud.h"

namespace gestalt {

/// Of the pixels that points fall into: the mean share of their neighbours into which points fall, too. Near 1 where
/// the points are as dense as the pixels; 0 where none is seen.
double filled_share(const PointCloud& cloud, const Camera& camera);

/// A camera from which the visible points fill the pixels: at their origin, looking along z, with square pixels as fine
/// as the points allow. Nothing where they are too few to tell.
std::optional<Camera> virtual_camera(const PointCloud& cloud);

/// The camera with fewer, larger pixels, such that the points fill them; the same where they do, or where they are
/// too few to tell.
Camera filled_camera(const PointCloud& cloud, const Camera& camera);

/// Share of the places in the image, of a few pixels each, where points lie far behind others: few where the points
/// were seen from their origin, most where they are given in another frame.
double overlapping_share(const PointCloud& cloud, const Camera& camera);

/// The same view in an image of another size.
Camera scaled(const Camera& camera, cv::Size size);

}  // namespace gestalt
