// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_ex: how large an object would be that has both patches (ours, not in the paper; proximity): the largest distance
/// from a contour point of one to a contour point of the other. Unlike the minimum distance it cannot be small for two
/// long things that touch at their ends, and it is small for the inner and outer wall of a cup whose contours do not
/// come near each other.
///
/// At most 48 evenly spread points of each outline are compared, so the value is too small by at most the length of a
/// 96th of both contours.
class JointExtent final : public Relation {
 public:
  struct Params {};
  static const Parameters<Params>& parameters();

  explicit JointExtent(const Params&) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;
};

}  // namespace gestalt
