// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>

#include "bspline_model.h"
#include "gestalt/core/plugin/fitter.h"
#include "gestalt/core/plugin/parameters.h"

namespace gestalt {

/// B-spline surface of least closest-point distances with minimal curvature (paper, Section 4.1, Eq. 5 to 7).
///
/// Every model keeps the means of its points in cells of a grid, and is fitted to those: the first fit is linear in the
/// number of points, every fit after it costs the same for any patch. Points far fewer than cells are their own means.
class Bspline final : public Fitter {
 public:
  struct Params {
    int degree = 2;              ///< d of Eq. 5
    int control_points_xi = 3;   ///< u: along the longest principal axis of the patch
    int control_points_eta = 3;  ///< v: along the second
    int knot_insertions = 0;     ///< further knots in each direction, in the span of the largest error
    int iterations = 3;          ///< closest points, then least squares
    double smoothness = 0.1;     ///< w_s of Eq. 6, in points; see smoothness_matrix()
    int cells = 12;              ///< in each direction, of the grid of means
  };
  static const Parameters<Params>& parameters();

  /// Throws ConfigError when a direction has not more control points than the degree.
  explicit Bspline(const Params& params);

  /// Three for each control point, inserted ones included.
  double parameter_count() const override;

  /// Null when refusal() has a reason.
  std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override;

  /// Costs the same for any number of points.
  std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a, std::span<const Eigen::Vector3f> points_a,
                                                 const SurfaceModel& b,
                                                 std::span<const Eigen::Vector3f> points_b) const override;

  /// Fewer points than control points, (nearly) collinear, as thick as wide, or folded over the principal plane.
  std::string refusal(std::span<const Eigen::Vector3f> points) const override;

 private:
  std::variant<PrincipalFrame, const char*> frame_of(std::span<const WeightedPoint> points,
                                                     std::span<const WeightedPoint> bounds) const;
  std::shared_ptr<const SurfaceModel> fit_to(std::span<const WeightedPoint> points,
                                             std::span<const WeightedPoint> bounds) const;

  Params params_;
  Eigen::MatrixXd smoothness_;  // of the surface before knots are inserted
};

}  // namespace gestalt
