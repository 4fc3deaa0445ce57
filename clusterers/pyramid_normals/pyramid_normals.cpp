// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "pyramid_normals.h"

#include <tbb/parallel_for.h>

#include <utility>
#include <vector>

#include "half_resolution.h"
#include "patch_refinement.h"

namespace gestalt {

const Parameters<PyramidNormals::Params>& PyramidNormals::parameters() {
  using P = Params;
  static const auto parameters = [] {
    Parameters<P> all;
    all.integer("levels", &P::levels, 1, 8, "", "resolutions, each half of the one before")
        .integer("reorganised_levels", &P::reorganised_levels, 0, 8, "",
                 "how many of the coarsest have neighbourhood-reorganised normals")
        .real("kappa_1", static_cast<double P::*>(&P::kappa_1), 0, 100, "",
              "cost of a patch in model selection between levels (Eq. 3), in points of the coarse patch")
        .real("kappa_2", static_cast<double P::*>(&P::kappa_2), 0, 100, "", "weight of the error there")
        .real("error_noise", static_cast<double P::*>(&P::error_noise), 0.01, 1000, "",
              "scale of the error there, in sigma(z)")
        .integer("reorganisation_radius", static_cast<int P::*>(&P::reorganisation_radius), 1, 10, "px",
                 "window in which a normal looks for those like it")
        .real("neighbour_weight", static_cast<double P::*>(&P::neighbour_weight), 0, 1e6, "",
              "alpha, pull of the neighbours")
        .real("likeness", static_cast<double P::*>(&P::likeness), 1e-9, 10, "",
              "beta, squared difference of normals at which the pull is down to a quarter")
        .integer("rounds", static_cast<int P::*>(&P::rounds), 0, 100, "", "most rounds of reorganisation");
    declare_tolerances(all);
    return all;
  }();
  return parameters;
}

PatchMap PyramidNormals::cluster(const Frame& frame) const {
  std::vector<PyramidLevel> levels{{frame, {}, Tolerances(frame, params_), {}}};
  for (int l = 1; l < params_.levels; ++l) {
    const PyramidLevel& finer = levels.back();
    levels.push_back({halve(finer.frame, finer.tolerances), {}, finer.tolerances.halved(), {}});
  }
  tbb::parallel_for(std::size_t{0}, levels.size(), [&](std::size_t l) {
    PyramidLevel& level = levels[l];
    level.normals = estimate_normals(level.frame, level.tolerances);
    if (int(levels.size() - l) <= params_.reorganised_levels)
      level.normals = reorganise(level.frame, std::move(level.normals), level.tolerances, params_);
    level.patches = tidy_outlines(level.frame, level.normals, level.tolerances,
                                  grow_patches(level.frame, level.normals, level.tolerances));
  });
  for (std::size_t l = levels.size() - 1; l > 0; --l)
    levels[l - 1].patches = select_patches(levels[l], levels[l - 1], params_);

  PyramidLevel& finest = levels.front();
  LabelledPatches patches =
      gather_leftovers(finest.frame, finest.normals, finest.tolerances, std::move(finest.patches));
  return {std::move(patches.labels), finest.normals.normals, patches.count, {}};
}

}  // namespace gestalt
