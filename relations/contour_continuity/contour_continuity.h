// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_ac and r_dn: does one surface go on in the other across the gap between them (paper, Section 6; continuity)?
/// Every contour point of either patch is paired with the nearest contour point of the other. Of each patch the share
/// of its points that are nearest, twenty percent, counts: r_ac is the mean angle between the normals of such a pair,
/// r_dn the mean distance between its points in the direction of their normals, (|n_p . d| + |n_q . d|) / 2 with d = q
/// - p. Points and normals are those of the fitted surfaces (Outline).
class ContourContinuity final : public Relation {
 public:
  struct Params {
    double share = 0.2;  ///< of the contour points of each patch, in (0, 1]; at least one counts
  };
  static const Parameters<Params>& parameters();

  explicit ContourContinuity(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
