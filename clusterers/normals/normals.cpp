// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normals.h"

namespace gestalt {

const Parameters<Normals::Params>& Normals::parameters() {
  using P = Normals::Params;
  static const auto parameters =
      Parameters<P>()
          .integer("window_radius", static_cast<int P::*>(&P::window_radius), 1, 50, "px",
                   "radius of the neighbourhood of a normal for points nearer than window_growth_start")
          .real("window_growth_start", static_cast<double P::*>(&P::window_growth_start), 0, 1000, "m",
                "depth from which on the neighbourhood grows")
          .real("window_growth_step", static_cast<double P::*>(&P::window_growth_step), 0.01, 1000, "m",
                "depth for each further pixel of radius")
          .real("neighbour_slope", static_cast<double P::*>(&P::neighbour_slope), 0.0001, 10, "",
                "a neighbour r px away counts when it is nearer than this * r * z")
          .real("angle", static_cast<double P::*>(&P::angle), 0, 3.2, "rad",
                "largest angle of a pixel's normal to its patch's mean normal, at z = 0")
          .real("angle_per_metre", static_cast<double P::*>(&P::angle_per_metre), -10, 10, "rad/m",
                "growth of that angle with depth")
          .real("distance", static_cast<double P::*>(&P::distance), -10, 10, "m",
                "largest distance of a pixel to its patch's plane, at z = 0")
          .real("distance_per_metre", static_cast<double P::*>(&P::distance_per_metre), -10, 10, "",
                "growth of that distance with depth")
          .integer("min_patch_size", static_cast<int P::*>(&P::min_patch_size), 1, 1000, "px",
                   "smaller patches are dissolved; their pixels are clustered by connectivity")
          .integer("spur_radius", static_cast<int P::*>(&P::spur_radius), 0, 50, "px",
                   "strips thinner than twice this and a pixel are given to the patches beside them")
          .real("spur_distance", static_cast<double P::*>(&P::spur_distance), 0, 1, "m",
                "a left-over pixel joins a patch that it touches within this distance")
          .integer("smallest_island", static_cast<int P::*>(&P::smallest_island), 0, 1000000, "px",
                   "smaller left-over components join a patch beside them, or none")
          .real("island_distance", static_cast<double P::*>(&P::island_distance), 0, 10, "m",
                "largest depth difference to that patch");
  return parameters;
}

PatchMap Normals::cluster(const Frame& frame) const {
  const NormalMap normals = estimate_normals(frame, params_);
  PatchMap map;
  map.labels = grow_patches(frame, normals, params_, map.count);
  map.normals = normals.normals;
  return map;
}

}  // namespace gestalt
