// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/scene/bspline_surface.h"
#include "weighted_points.h"

namespace gestalt {

/// What a model keeps of the points that it was fitted to: bounded in size.
struct PatchDigest {
  std::vector<WeightedPoint> means;     ///< of the cells, at most cells x cells
  std::vector<WeightedPoint> extremes;  ///< the points farthest out
};

/// A fitted B-spline surface. It ends at the rectangle of its patch: what lies beyond has its foot on the border.
class BsplineModel final : public SurfaceModel {
 public:
  BsplineModel(BsplineSurface surface, const PrincipalFrame& frame, PatchDigest digest)
      : surface_(std::move(surface)), frame_(frame), digest_(std::move(digest)) {}

  const BsplineSurface& surface() const { return surface_; }
  const PatchDigest& digest() const { return digest_; }

  std::string type() const override { return "bspline"; }
  Foot foot(const Eigen::Vector3f& p) const override;
  float squared_distance(const Eigen::Vector3f& p) const override;
  std::optional<Eigen::Vector2d> parameters(const Eigen::Vector3f& p) const override;
  nlohmann::json to_json() const override;

 private:
  BsplineSurface surface_;
  PrincipalFrame frame_;
  PatchDigest digest_;
};

}  // namespace gestalt
