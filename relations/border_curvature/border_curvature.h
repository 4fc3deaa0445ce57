// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_cu3 and r_cv3: mean and variance of the curvature over the 3D border (paper, Section 5). At a pair of touching
/// pixels it is angle(n_a, d) + angle(n_b, -d) - pi, with d the unit direction from patch a to patch b: the angle
/// between the two surfaces, positive on a convex edge, negative on a concave one.
///
/// Two touching pixels are millimetres apart, and so is their noise: d runs from the mean of patch a to the mean of
/// patch b within support pixels of the border.
class BorderCurvature final : public Relation {
 public:
  struct Params {
    int support = 10;                ///< px
    std::string normals = "fitted";  ///< of the fitted surfaces, or "local": of a plane through the support
    int samples = 64;                ///< border pairs that are looked at, evenly spread
  };
  static const Parameters<Params>& parameters();

  explicit BorderCurvature(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_border() const override { return true; }
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
