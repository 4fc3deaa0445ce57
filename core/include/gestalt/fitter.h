// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <memory>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <span>
#include <string>

#include "gestalt/export.h"

namespace gestalt {

/// A parametric surface fitted to a patch (paper, Section 4). Immutable; camera frame, metres.
class GESTALT_EXPORT SurfaceModel {
 public:
  struct Foot {
    Eigen::Vector3f point;   ///< closest point on the surface
    Eigen::Vector3f normal;  ///< unit normal there, towards the camera
  };

  virtual ~SurfaceModel();

  /// "plane", "bspline", ...: the name of the fitter.
  virtual std::string type() const = 0;

  /// Closest point of the surface to p. Finite for every finite p.
  virtual Foot foot(const Eigen::Vector3f& p) const = 0;

  /// Squared distance of p to the surface in square metres; override where it is cheaper than foot().
  virtual float squared_distance(const Eigen::Vector3f& p) const;

  /// What result.json tells of the surface.
  virtual nlohmann::json to_json() const = 0;

  /// Parameters of foot(p) on the surface, in which result.json gives its outline: what they mean, to_json() tells.
  /// None (the default) for a surface that is not parametrised.
  virtual std::optional<Eigen::Vector2d> parameters(const Eigen::Vector3f& p) const;
};

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
  /// fits anew; a fitter whose normal equations add up overrides it.
  virtual std::shared_ptr<const SurfaceModel> fit_merged(const SurfaceModel& a,
                                                         std::span<const Eigen::Vector3f> points_a,
                                                         const SurfaceModel& b,
                                                         std::span<const Eigen::Vector3f> points_b) const;

  /// Why fit() gives no surface for these points, in a few words ("collinear points"), for result.json; "" when it
  /// gives one, or does not tell (the default).
  virtual std::string refusal(std::span<const Eigen::Vector3f> points) const;
};

}  // namespace gestalt
