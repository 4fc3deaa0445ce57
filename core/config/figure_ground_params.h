// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/base/export.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// Settings of find_roles(). Nothing is in pixels, and nothing assumes a pose of the camera.
struct FigureGroundParams {
  double tolerance = 4;  ///< sigma(z) of the sensor; points nearer to a plane than this lie in it
  double margin = 0.1;   ///< of a support's diameter; what stands this far outside its hull stands on it
  double relative_area =
      0.25;  ///< of the ground's area; a smaller plane is neither a wall nor a table in contact with it
  double smallest_support = 0.05;  ///< m^2; a smaller plane is not a table, even when nothing connects it to the ground
  double largest_remainder = 0.02;  ///< of the frame's points; fewer than this beyond a plane are noise
  double max_depth = 0;             ///< m; everything farther away is background; 0: off
  double min_object = 2;            ///< cm^2 that the camera sees; what shows less is background
  double least_extent = 8;          ///< sigma(z); what shows less than this squared is background
  bool separate = true;             ///< an object's surface and the background's are never joined

  GESTALT_EXPORT static const Parameters<FigureGroundParams>& parameters();
};

}  // namespace gestalt
