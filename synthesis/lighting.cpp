// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "lighting.h"

#include <Eigen/Geometry>

namespace gestalt::synthesis {

Lighting random_lighting(Random& random) {
  Lighting lighting;
  lighting.lamp << random.uniform(-1.2, 1.2), random.uniform(-0.8, 1.2), random.uniform(1.5, 2.4);
  lighting.lamp_radius = random.uniform(0.15, 0.5);
  lighting.window =
      Eigen::Vector3d{random.chance(0.5) ? 1.0 : -1.0, random.uniform(-1, 0.4), random.uniform(0.4, 1)}.normalized();
  const double brightness = random.uniform(0.9, 1.1);
  lighting.lamp_strength = brightness * random.uniform(0.5, 0.7);
  lighting.window_strength = brightness * random.uniform(0.1, 0.25);
  lighting.ambient = brightness * random.uniform(0.42, 0.58);
  for (int c = 0; c < 3; ++c) lighting.tint[c] = float(random.uniform(0.93, 1.07));
  return lighting;
}

}  // namespace gestalt::synthesis
