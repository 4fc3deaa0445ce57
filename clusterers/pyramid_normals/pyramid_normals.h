// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/clusterer.h"
#include "gestalt/core/plugin/parameters.h"
#include "level_selection.h"
#include "reorganised_normals.h"
#include "tolerances.h"

namespace gestalt {

/// The paper's signal level (Section 3): planar patches by recursive clustering of normals on a pyramid of resolutions,
/// with neighbourhood-reorganised normals on the coarse ones, and model selection from coarse to fine.
class PyramidNormals final : public Clusterer {
 public:
  struct Params : ToleranceParams, ReorganisationParams, SelectionParams {
    int levels = 3;              ///< each has half the resolution of the one before
    int reorganised_levels = 2;  ///< of the coarsest
  };
  static const Parameters<Params>& parameters();

  explicit PyramidNormals(const Params& params) : params_(params) {}
  PatchMap cluster(const Frame& frame) const override;

 private:
  Params params_;
};

}  // namespace gestalt
