// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_cs and r_oc: how straight a boundary line of one patch goes on in one of the other, and how far behind that which
/// lies in between the line would run (paper, Section 6). Both are of the pair's collinearity with the lowest r_cs.
class Collinearity final : public Relation {
 public:
  struct Params {
    double distance_scale = 0.1;  ///< m; an offset of the lines that counts like a right angle between them
  };
  static const Parameters<Params>& parameters();

  explicit Collinearity(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
