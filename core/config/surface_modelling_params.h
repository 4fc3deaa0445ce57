// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/base/export.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// Settings of the primitive level (paper, Section 4.3, Eq. 3 and 8). Lengths are given in multiples of what the sensor
/// can tell apart, so that they hold for any camera: its noise, and the footprint z / f of a pixel.
struct SurfaceModellingParams {
  double sigma = 2.5;                     ///< p(f_i | H) = exp(-e_i^2 / s^2), s = sigma * noise(z)
  double kappa_1 = 0.0053;                ///< weight of the number of parameters
  double kappa_2 = 1.0;                   ///< weight of the error
  std::string normalisation = "smaller";  ///< A_m of Eq. 3 for a pair: size of the smaller patch, or of the merged one
  std::string merger_fitters = "all";     ///< whose surface may replace two: "all", or "after_first" (Algorithm 1)
  double largest_solid_angle = 0.03;  ///< sr; the first fitter alone models and merges a larger patch (walls, table)
  double neighbour_depth = 3.0;       ///< touching pixels with |dz| < this * (noise(z) + z / f) may merge
  double border_depth = 1.8;          ///< touching pixels with |dz| < this * (noise(z) + z / f) are 3D border

  GESTALT_EXPORT static const Parameters<SurfaceModellingParams>& parameters();
};

}  // namespace gestalt
