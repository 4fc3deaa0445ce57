// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "colour_cuts.h"
#include "gestalt/core/plugin/clusterer.h"
#include "gestalt/core/plugin/parameters.h"
#include "tolerances.h"

namespace gestalt {

/// Planar patches by recursive clustering of z-adaptive normals (paper, Section 3, on one level of the pyramid), cut
/// along colour edges where cut_share is not 0 and the frame has colour.
class Normals final : public Clusterer {
 public:
  struct Params : ToleranceParams, ColourCutParams {};
  static const Parameters<Params>& parameters();

  explicit Normals(const Params& params) : params_(params) {}
  PatchMap cluster(const Frame& frame) const override;

 private:
  Params params_;
};

}  // namespace gestalt
