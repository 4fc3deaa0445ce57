// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_tr: difference of texture quantity (paper, Section 5). A patch's texture quantity is the share of its pixels that
/// are Canny edges of the grey image; r_tr is the absolute difference of the two shares, in [0, 1].
class TextureQuantity final : public Relation {
 public:
  struct Params {
    int blur = 3;
    double low_threshold = 5;
    double high_threshold = 140;
  };
  static const Parameters<Params>& parameters();

  explicit TextureQuantity(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  bool needs_colour() const override { return true; }
  std::unique_ptr<Observation> observe(const Images& images) const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
