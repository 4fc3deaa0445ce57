// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>

#include "gestalt/core/scene/boundary_lines.h"

namespace gestalt {

/// z of the cross product of two directions in the image.
inline float cross(const Eigen::Vector2f& x, const Eigen::Vector2f& y) { return x.x() * y.y() - x.y() * y.x(); }

/// Pixels of this camera that show what one pixel shows at a focal length of 525 px.
inline float pixel_scale(const Camera& camera) { return float(std::max(camera.fx, camera.fy) / 525); }

/// Cuts lines in two where another one ends on them, in the image and in 3D. Fills t_junctions.
void split_where_met(const Frame& frame, BoundaryLines& lines);

/// Fills junctions and collinearities.
void link_lines(const Frame& frame, BoundaryLines& lines);

}  // namespace gestalt
