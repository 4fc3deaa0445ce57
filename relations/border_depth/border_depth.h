// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_di2 and r_vd2: mean and variance of the absolute depth difference over the 2D border (paper, Section 5), in metres
/// and square metres. Both are 0 for patches that do not touch in the image.
class BorderDepth final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit BorderDepth(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_border() const override { return true; }
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
