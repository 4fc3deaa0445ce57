// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/config/figure_ground_params.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/role.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// Role of every surface. Pixels count by 1/z^2, so that what is within reach outweighs the room around it. Supports
/// are
/// * the ground: of all planes the one with the largest share of the frame in it, or in front of it and over its hull,
///   less what is behind it;
/// * walls, floors: planes of relative_area with nothing behind them;
/// * tables in front of the ground that things touch and stand on: of relative_area; or that weigh more than the ground
///   and touch it with their legs at most; or, when no chain of touching surfaces leads to another support (the top of
///   a box is led to the ground by the box's sides), of smallest_support over the ground's hull and of
///   largest_remainder of the frame's points outside it;
/// * bottoms of open containers, of smallest_support: two walls rise from them along most of their sides.
/// Stages are the supports that carry most, but not the floor under a table. Objects are what is in front of a stage
/// and over it, or beside it by less than margin. Background are the supports, the walls of a stage that is the bottom
/// of a container, all that is beyond, beside or below the stages, what lies farther away than max_depth, and small
/// dents of a stage, which are errors of depth. All surfaces in a support's plane belong to it, so that a table stays
/// one when objects divide it. A plane is as thick as its own points are rough, up to a hundredth of its size. A plane
/// that has something behind it and nothing in front is not a support, so that in a frame full of one object everything
/// is object; a frame full of one plane is background. Without a support all within max_depth is object; without any
/// surface the result is empty.
GESTALT_EXPORT std::vector<Role> find_roles(const Frame& frame, const SurfaceSet& surfaces,
                                            const FigureGroundParams& params);

/// How much the camera sees of each surface: the area that its pixels cover at their depth, as if seen from the front,
/// in units of the least that an object shows, the larger one of min_object and (least_extent sigma(z))^2. Sizes of
/// surfaces add up to that of a segment; one of less than 1 is background.
GESTALT_EXPORT std::vector<double> find_sizes(const Frame& frame, const SurfaceSet& surfaces,
                                              const FigureGroundParams& params);

}  // namespace gestalt
