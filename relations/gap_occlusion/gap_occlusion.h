// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/plugin/relation.h"

namespace gestalt {

/// r_go and r_gl: is something in front of the gap between two patches, so that they may go on behind it (ours, not in
/// the paper, which asks this for collinear boundary lines only: r_oc)? Every contour point is joined with the contour
/// point of the other patch that is nearest in the image; of each patch the nearest share of these lines counts. At up
/// to 32 pixels between the ends of a line, except where it crosses the patches themselves, its depth is compared with
/// the measured one:
///   r_go  mean of the depth of the line minus the measured depth, each limited to +-limit: positive when the gap is
///         covered by something nearer, negative when it shows what is farther away, as no object does that goes on
///   r_gl  share of the pixels where something lies where the line is: a third surface, often another object
/// Lines weigh the same whatever their length. A pixel without depth counts as difference 0 and not as level. Patches
/// without a pixel between them have 0 and 0.
class GapOcclusion final : public Relation {
 public:
  struct Params {
    double share = 0.2;    ///< of the lines of each patch, the shortest in the image, in (0, 1]; at least one counts
    double limit = 0.1;    ///< m; larger differences of depth count as this
    double slack = 0.006;  ///< m; added to the noise of depth for what counts as level
  };
  static const Parameters<Params>& parameters();

  explicit GapOcclusion(const Params& params) : params_(params) {}
  const std::vector<RelationValue>& values() const override;
  std::unique_ptr<Measure> bind(const Scene& scene) const override;

 private:
  Params params_;
};

}  // namespace gestalt
