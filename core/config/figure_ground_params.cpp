// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/config/figure_ground_params.h"

namespace gestalt {

const Parameters<FigureGroundParams>& FigureGroundParams::parameters() {
  using P = FigureGroundParams;
  static const auto parameters =
      Parameters<P>()
          .real("tolerance", &P::tolerance, 0, 100, "sigma",
                "points nearer to a plane than this times sigma(z) lie in it")
          .real("margin", &P::margin, 0, 10, "",
                "things up to this share of a support's diameter outside its hull still stand on it")
          .real("relative_area", &P::relative_area, 0, 1, "",
                "walls, and tables that touch the ground, have at least this share of its area")
          .real("smallest_support", &P::smallest_support, 0, 1000, "m^2",
                "tables that do not touch the ground have at least this area")
          .real("largest_remainder", &P::largest_remainder, 0, 1, "",
                "a share of the frame's points below this is noise")
          .real("max_depth", &P::max_depth, 0, 1000, "m", "everything farther away is background; 0: off")
          .real("min_object", &P::min_object, 0, 1e6, "cm^2", "segments with a smaller visible area are background")
          .real("least_extent", &P::least_extent, 0, 1000, "sigma",
                "segments with a visible area below the square of this times sigma(z) are background, as noise may be "
                "as large")
          .boolean("separate", &P::separate, "an object's surface and the background's are never joined");
  return parameters;
}

}  // namespace gestalt
