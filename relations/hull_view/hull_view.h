// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_hb, r_ho, r_hn and r_hh: what is seen through the common hull of two patches (ours, not in the paper; closure and
/// convexity)? An object fills the space between its visible parts, or hollows it out from inside. Lines run between 12
/// evenly spread contour points of either patch, all with all, and at 10 pixels of each the depth of the line is
/// compared with the measured one. Of all these pixels
///   r_hb  is the share where another surface is seen behind the line: the space between the patches is empty
///   r_ho  the share of those whose surface lies outside of the sphere over the longest of the lines as well, so that
///         it cannot be the inside of a hollow object that the two belong to
///   r_hn  the ratio of r_hb to the share where another surface is seen behind the line or in front of it: 0 when the
///         space is covered all over, 1 when it is empty all over; 0 when no other surface is seen
///   r_hh  the share where one of the two patches itself is seen behind the line: a hollow, as the inside of a cup
class HullView final : public Relation {
 public:
  struct Params {
    double slack = 0.006;  ///< m; added to the noise of depth for what counts as level with a line
  };
  static const Parameters<Params>& parameters();

  explicit HullView(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
