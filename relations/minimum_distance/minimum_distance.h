// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_md: minimum distance between two patches (paper, Section 6; proximity), between the points of their contours on
/// the fitted surfaces. Exact for contours of up to Outline::largest pixels; of longer ones every n-th pixel is taken,
/// and the value exceeds the true one by at most the length of n / 2 steps along either contour.
class MinimumDistance final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit MinimumDistance(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
