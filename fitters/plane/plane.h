// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// Plane by linear least squares (paper, Section 4.2). A patch whose points leave a direction open
/// (one point, or collinear points) gets the plane that faces the camera most among those that fit.
class Plane final : public Fitter {
 public:
  struct Params {
    double parameter_count = 12;  ///< what the authors' program counts for a plane; a B-spline of 3 x 3 points has 27
  };
  static const Parameters<Params>& parameters();

  explicit Plane(const Params& params) : params_(params) {}
  double parameter_count() const override { return params_.parameter_count; }

  /// Null for no points.
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override;

  /// Costs the same for any number of points: the moments of two patches add up.
  std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a, std::span<const Eigen::Vector3f> points_a,
                                                 const SurfaceModel& b,
                                                 std::span<const Eigen::Vector3f> points_b) const override;

 private:
  Params params_;
};

}  // namespace gestalt
