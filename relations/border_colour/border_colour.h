// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_co3: colour similarity on the 3D border (paper, Section 5). Mean over the border's pixel pairs of 1 - d / d_max,
/// where d is the distance of the two colours in the 8-bit UV plane and d_max = 255 sqrt(2) that plane's diagonal: 1
/// for equal chroma, whatever the brightness. Two surfaces that touch only in the image are compared on their 2D
/// border; surfaces that do not touch have 0.
class BorderColour final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit BorderColour(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  bool needs_border() const override { return true; }
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
