// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_nm and r_nv: angle between the mean normals of two patches and difference of the variances of their normals
/// (paper, Section 6; similarity of shape). The variance is the mean squared difference to the mean normal m, 1 -
/// |m|^2: 0 for a plane, 1 - (2/pi)^2 = 0.59 for half a cylinder.
class MeanNormals final : public Relation {
 public:
  struct Params {
    std::string normals = "fitted";  ///< of the fitted surfaces, or "measured": of the signal level
    int samples = 256;               ///< pixels of a patch that are looked at, evenly spread
  };
  static const Parameters<Params>& parameters();

  explicit MeanNormals(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
