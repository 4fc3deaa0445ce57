// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_co: similarity of patch colour (paper, Section 5), the Bhattacharyya coefficient of the two patches'
/// three-dimensional histograms over Y, U and V: 1 for patches of the same colours, 0 for patches without a common bin.
class ColourHistogram final : public Relation {
 public:
  struct Params {
    int bins = 4;
  };
  static const Parameters<Params>& parameters();

  explicit ColourHistogram(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
