// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normals.h"

#include "normal_estimation.h"
#include "patch_growing.h"
#include "patch_refinement.h"

namespace gestalt {

const Parameters<Normals::Params>& Normals::parameters() {
  static const auto parameters = [] {
    Parameters<Params> all;
    declare_tolerances(all);
    declare_colour_cuts(all);
    return all;
  }();
  return parameters;
}

PatchMap Normals::cluster(const Frame& frame) const {
  const Tolerances tolerances(frame, params_);
  const NormalMap map = estimate_normals(frame, tolerances);
  LabelledPatches patches = tidy_outlines(frame, map, tolerances, grow_patches(frame, map, tolerances));
  patches = gather_leftovers(frame, map, tolerances, std::move(patches));
  if (params_.cut_share == 0 || !frame.has_colour()) return {std::move(patches.labels), map.normals, patches.count, {}};
  CutPatches cut = cut_along_colour_edges(frame, patches, params_);
  return {std::move(cut.patches.labels), map.normals, cut.patches.count, std::move(cut.grown)};
}

}  // namespace gestalt
