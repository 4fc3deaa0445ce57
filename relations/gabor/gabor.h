// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gabor_bank.h"
#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_ga: Gabor filter match (paper, Section 5), a distance of texture. A surface's feature is the mean and the standard
/// deviation of the magnitude of each of 6 x 5 Gabor filters; the distance of two is the sum over the filters of
/// sqrt(d_mean^2 + d_deviation^2), at that cyclic shift of one surface's directions that makes it smallest: texture
/// that is turned is the same texture.
///
/// It is divided by the energy of the surface that has more, energy being the sum over the filters of
/// sqrt(mean^2 + deviation^2) and at least least_energy: r_ga is in [0, 2], does not depend on contrast and is about 0
/// for two surfaces that show nothing but the camera's noise, whose energy is 2 to 3 in a Kinect's image.
class Gabor final : public Relation {
 public:
  struct Params : GaborBank {
    double least_energy = 5;
  };
  static const Parameters<Params>& parameters();

  /// Throws ConfigError when the coarsest kernel is unreasonably large.
  explicit Gabor(const Params& params);
  const std::vector<RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  std::unique_ptr<Observation> observe(const Images& images) const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
