// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gestalt/core/plugin/clusterer.h>
#include <gestalt/core/plugin/parameters.h>

/// Connected pixels of like normals, like colour and without a jump of depth: two books that lie flush beside each
/// other are two patches, which geometry alone cannot see.
class ColouredRegions final : public gestalt::Clusterer {
 public:
  struct Params {
    int radius = 4;       ///< a normal is taken from the pixels at this distance
    double angle = 0.35;  ///< largest angle of a normal to the mean of its patch
    double jump = 0.01;   ///< neighbours whose depths differ by more than this share of their depth are not connected
    double colour = 40;   ///< largest difference of a pixel's colour, brightness aside, to the mean of its patch
    int smallest = 20;    ///< smaller regions are not made patches
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit ColouredRegions(const Params& params) : params_(params) {}
  gestalt::PatchMap cluster(const gestalt::Frame& frame) const override;

 private:
  Params params_;
};
