// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "gestalt/fitter.h"
#include "gestalt/frame.h"
#include "gestalt/parameters.h"
#include "gestalt/patch_map.h"
#include "gestalt/surface_set.h"

namespace gestalt {

/// Settings of the primitive level (paper, Section 4.3, Eq. 3 and 8).
struct SurfaceModellingParams {
  double sigma = 0.003;           ///< m; p(f_i | H) = exp(-e_i^2 / sigma(z)^2)
  double sigma_z = 0.0;           ///< 1/m; sigma(z) = sigma + sigma_z * z^2
  double kappa_1 = 0.008;         ///< weight of the number of parameters
  double kappa_2 = 1.0;           ///< weight of the error
  int largest_patch = 8000;       ///< px; a larger patch is only modelled by the first fitter (walls, table)
  double neighbour_depth = 0.01;  ///< m; touching pixels closer in depth make two patches candidates for merging
  double border_depth_per_metre = 0.007;  ///< touching pixels with |dz| < this * z are 3D border

  static const Parameters<SurfaceModellingParams>& parameters();
};

/// Primitive level, Algorithm 1: chooses for every patch the fitter with the largest savings, then merges 3D neighbours
/// greedily, best gain first, while S_ij > S_i + S_j (Eq. 8), and collects borders and neighbours of what results.
/// fitters: in the config's order; the first must fit any patch. Deterministic for any number of threads.
GESTALT_EXPORT SurfaceSet model_surfaces(const Frame& frame, const PatchMap& patches,
                                         const std::vector<std::shared_ptr<const Fitter>>& fitters,
                                         const SurfaceModellingParams& params);

/// The adjacencies of a label image (0 = none, else 1 + index), sorted by (a, b).
GESTALT_EXPORT std::vector<Adjacency> find_adjacencies(const Frame& frame, const cv::Mat_<int>& labels,
                                                       const SurfaceModellingParams& params);

}  // namespace gestalt
