// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace gestalt {

/// Standard deviation of a sensor's depth reading, in metres, as a polynomial of the depth z in metres.
struct DepthNoise {
  double constant = 0.0015;   ///< m
  double linear = -0.0015;    ///< dimensionless
  double quadratic = 0.0019;  ///< 1/m

  /// sigma(z) for z > 0, never below 0.1 mm.
  double at(double z) const {
    const double sigma = constant + z * (linear + z * quadratic);
    return sigma > 1e-4 ? sigma : 1e-4;
  }
};

}  // namespace gestalt
