// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_ls, r_as and r_lg: the best that a closed convex contour with lines of both patches explains of their boundaries
/// and of their areas, and how much of it is gap (paper, Section 6). Each is the best over all such contours.
class ClosureRelation final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit ClosureRelation(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
