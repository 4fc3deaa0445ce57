// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_sp: does the surface fitted to one patch predict where the other is (ours, not in the paper; continuity over the
/// whole patch, where r_dn looks at the sides that face each other)? The mean distance of 24 evenly spread contour
/// points of one patch to the fitted surface of the other, which a plane continues without end; of both ways the
/// smaller.
class CommonSurface final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit CommonSurface(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
