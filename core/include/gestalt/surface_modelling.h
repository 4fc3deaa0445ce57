// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "gestalt/export.h"
#include "gestalt/fitter.h"
#include "gestalt/frame.h"
#include "gestalt/parameters.h"
#include "gestalt/patch_map.h"
#include "gestalt/surface_set.h"

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

/// Primitive level, Algorithm 1: chooses for every patch the fitter with the largest savings, then merges 3D neighbours
/// greedily, best gain first, while S_ij > S_i + S_j (Eq. 8), and collects borders and neighbours of what results.
/// fitters: in the config's order; the first must fit any patch. Deterministic for any number of threads.
GESTALT_EXPORT SurfaceSet model_surfaces(const Frame& frame, const PatchMap& patches,
                                         const std::vector<std::shared_ptr<const Fitter>>& fitters,
                                         const SurfaceModellingParams& params);

/// Whether the depths of two pixels differ by less than reach times what the sensor can tell apart: its noise there
/// plus the footprint of a pixel, which is the step between neighbours on a surface at 45 degrees to the view.
GESTALT_EXPORT bool are_close(const Frame& frame, const PixelPair& pair, double reach);

/// The adjacencies of a label image (0 = none, else 1 + index), sorted by (a, b).
GESTALT_EXPORT std::vector<Adjacency> find_adjacencies(const Frame& frame, const cv::Mat_<int>& labels,
                                                       const SurfaceModellingParams& params);

}  // namespace gestalt
