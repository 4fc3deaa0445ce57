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

/// Role of every surface. Background are supports - planes that things are in front of - and what lies beyond:
/// behind a support, or over none. The rest are objects. Supports are
/// * the ground: of all planes the one with the largest share of the frame's points in it, or in front of it and over
///   its hull, less those behind it;
/// * walls, floors: planes of relative_area with nothing behind them;
/// * tables in front of the ground that things touch and stand on: of relative_area; or, when no chain of touching
///   surfaces leads to another support (the top of a box is led to the ground by the box's sides), of smallest_support
///   over the ground's hull and of largest_remainder of the frame's points outside it.
/// All surfaces in a support's plane belong to it, so that a table stays one when objects divide it.
/// A plane that has something behind it and nothing in front is no support, so that in a frame full of one object
/// everything is object; a frame full of one plane is background. Without any surface the result is empty.
GESTALT_EXPORT std::vector<Role> find_roles(const Frame& frame, const SurfaceSet& surfaces,
                                            const FigureGroundParams& params);

/// How much the camera sees of each surface: the area that its pixels cover at their depth, seen from the front, in units
/// of the least that an object shows: min_object, or what noise makes of nothing, (least_extent sigma(z))^2. Sizes of
/// surfaces add up; a segment of less than 1 is background.
GESTALT_EXPORT std::vector<double> find_sizes(const Frame& frame, const SurfaceSet& surfaces,
                                              const FigureGroundParams& params);

}  // namespace gestalt
