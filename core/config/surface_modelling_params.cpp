// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/surface_modelling_params.h"

namespace gestalt {

const Parameters<SurfaceModellingParams>& SurfaceModellingParams::parameters() {
  using P = SurfaceModellingParams;
  static const auto parameters =
      Parameters<P>()
          .real("sigma", &P::sigma, 0.01, 1000, "noise",
                "scale of the error model, p(f | H) = exp(-e^2 / (sigma noise(z))^2)")
          .real("kappa_1", &P::kappa_1, 0, 100, "", "weight of the number of parameters (Eq. 3)")
          .real("kappa_2", &P::kappa_2, 0, 100, "", "weight of the error (Eq. 3)")
          .choice("normalisation", &P::normalisation, {"smaller", "merged"},
                  "A_m of a pair (Eq. 3): the size of the smaller patch, or of the merged one")
          .choice("merger_fitters", &P::merger_fitters, {"all", "after_first"},
                  "whose surface may replace two patches: any fitter's, or any but the first's (Algorithm 1)")
          .real("largest_solid_angle", &P::largest_solid_angle, 0, 10, "sr",
                "a patch that covers more of the view is modelled, and merged, by the first fitter alone")
          .real("neighbour_depth", &P::neighbour_depth, 0, 1000, "",
                "touching pixels closer in depth than this * (noise(z) + z / f) make patches candidates for merging")
          .real("border_depth", &P::border_depth, 0, 1000, "",
                "touching pixels closer in depth than this * (noise(z) + z / f) are 3D border");
  return parameters;
}

}  // namespace gestalt
