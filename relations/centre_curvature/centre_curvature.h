// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_cc and r_cd: do two patches face away from each other, as the sides of a solid thing do, or towards each other, as
/// those of two things beside one another do (ours, not in the paper; it carries r_cu3 over to patches that do not
/// touch)? angle(n_a, d) + angle(n_b, -d) - pi with the mean normals and the unit direction d from centre to centre:
/// positive when they face away from each other, negative when they face each other, 0 for parallel patches whatever
/// their offset. r_cd is the difference of the two angles, | angle(n_a, d) - angle(n_b, -d) |: 0 when they lie beside
/// each other, pi when one lies straight behind the other, as the walls of a cup do.
class CentreCurvature final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit CentreCurvature(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
