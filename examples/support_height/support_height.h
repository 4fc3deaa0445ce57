// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

/// r_sh: how high a pair stands over its support, the largest patch of the scene: the smaller of the two patches' mean
/// heights over that patch's surface, metres. Near 0 when one of the two is the table itself.
class SupportHeight final : public gestalt::Relation {
 public:
  struct Params {
    double highest = 0.5;  ///< m; greater heights count as this
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit SupportHeight(const Params& params) : params_(params) {}
  const std::vector<gestalt::RelationValue>& values() const override;
  std::unique_ptr<gestalt::Measure> bind(const gestalt::Scene& scene) const override;

 private:
  Params params_;
};
