// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <memory>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/config/surface_modelling_params.h"
#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/patch_map.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

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
