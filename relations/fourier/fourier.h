// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_fo: Fourier filter match (paper, Section 5). At each pixel the grey values of its 8 neighbours, taken in ring
/// order, have the discrete Fourier coefficients X_0..X_4 (the rest are their conjugates). The magnitudes |X_k| / 8
/// make one histogram for each k over the patch; r_fo is the mean of the five Bhattacharyya coefficients, in [0, 1].
/// The magnitudes do not change when the ring turns. Beyond the image's edge its last pixel is repeated.
///
/// The bins of X_0, the ring's mean, are bin_width wide; the other coefficients are small, so that bins of X_k, k >= 1,
/// are bin_width / (divisor_offset + divisor_slope k) wide. The last bin is open.
class Fourier final : public Relation {
 public:
  struct Params {
    int bins = 8;
    double bin_width = 32;
    double divisor_offset = 2;
    double divisor_slope = 6;
  };
  static const Parameters<Params>& parameters();

  explicit Fourier(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  std::unique_ptr<Observation> observe(const Images& images) const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
