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
    return all;
  }();
  return parameters;
}

PatchMap Normals::cluster(const Frame& frame) const {
  const Tolerances tolerances(frame, params_);
  const NormalMap map = estimate_normals(frame, tolerances);
  LabelledPatches patches = tidy_outlines(frame, map, tolerances, grow_patches(frame, map, tolerances));
  patches = gather_leftovers(frame, map, tolerances, std::move(patches));
  return {std::move(patches.labels), map.normals, patches.count};
}

}  // namespace gestalt
