// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_rs: relative patch size similarity (paper, Section 5), the smaller pixel count over the larger, in (0, 1].
class RelativeSize final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit RelativeSize(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
