// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "gestalt/export.h"
#include "gestalt/frame.h"
#include "gestalt/parameters.h"
#include "gestalt/surface_set.h"

namespace gestalt {

/// What a surface or segment is: a thing, or what things stand on, lean on and are seen against.
enum class Role { object, background };

/// "object" or "background".
GESTALT_EXPORT std::string_view name_of(Role role);

/// Settings of find_roles(). Nothing is in pixels, and nothing assumes a pose of the camera.
struct FigureGroundParams {
  double tolerance = 4;         ///< sigma(z) of the sensor; points nearer to a plane than this lie in it
  double margin = 0.1;          ///< of a support's diameter; what stands this far outside its hull stands on it
  double relative_area = 0.25;  ///< of the ground's area; a smaller plane is no wall, and no table in contact with it
  double smallest_support = 0.05;   ///< m^2; a smaller plane is no table, even when nothing connects it to the ground
  double largest_remainder = 0.02;  ///< of the frame's points; fewer than this beyond a plane are noise
  bool separate = true;             ///< an object's surface and the background's are never joined

  GESTALT_EXPORT static const Parameters<FigureGroundParams>& parameters();
};

/// Role of every surface. Background are supports - planes that things are in front of - and what lies beyond:
/// behind a support, or over none. The rest are objects. Supports are
/// * the ground: of all planes the one with the largest share of the frame's points in it, or in front of it and over
/// its
///   hull, less those behind it;
/// * walls, floors: planes of relative_area with nothing behind them;
/// * tables in front of the ground that things touch and stand on: of relative_area; or, when no chain of touching
///   surfaces leads to another support (the top of a box is led to the ground by the box's sides), of smallest_support
///   over the ground's hull and of largest_remainder of the frame's points outside it.
/// All surfaces in a support's plane belong to it, so that a table stays one when objects divide it.
/// A plane that has something behind it and nothing in front is no support, so that in a frame full of one object
/// everything is object; a frame full of one plane is background. Without any surface the result is empty.
GESTALT_EXPORT std::vector<Role> find_roles(const Frame& frame, const SurfaceSet& surfaces,
                                            const FigureGroundParams& params);

}  // namespace gestalt
