// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_th: difference of the heights at which two patches end at the top (ours, not in the paper; the principle of common
/// fate: what ends together belongs together). The inner and outer wall of a cup end at the same rim, the sides of a
/// box at the same edge; things beside one another rarely do. Heights run along the normal of the scene's largest
/// patch, the uppermost of several: the support, or a floor that is parallel to it. Where a wall is larger still, the
/// value says how far two patches stick out towards the camera.
///
/// The top is the 97th percentile of the heights of at most 1000 evenly spread pixels of a patch.
class CommonHeight final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit CommonHeight(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
