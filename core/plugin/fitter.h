// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <span>
#include <string>

#include "gestalt/core/scene/surface_model.h"

namespace gestalt {

/// Primitive level: fits one type of surface to the points of a patch.
class GESTALT_EXPORT Fitter {
 public:
  virtual ~Fitter();

  /// Cost of coding the model, S_m of Eq. 3: its number of parameters.
  virtual double parameter_count() const = 0;

  /// Fits a surface to points (metres, camera frame). Null when they do not determine one (too few, collinear).
  /// The caller falls back to the next fitter; the first fitter of a config must accept any non-empty patch.
  virtual std::shared_ptr<const SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const = 0;

  /// Fits one surface to the joined points of two patches that this fitter has modelled before, a and b. The default
  /// fits again; a fitter whose normal equations add up overrides it.
  virtual std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a,
                                                         std::span<const Eigen::Vector3f> points_a,
                                                         const SurfaceModel& b,
                                                         std::span<const Eigen::Vector3f> points_b) const;

  /// Why fit() gives no surface for these points, in a few words ("collinear points"), for result.json; "" when it
  /// gives one, or does not tell (the default).
  virtual std::string refusal(std::span<const Eigen::Vector3f> points) const;
};

}  // namespace gestalt
