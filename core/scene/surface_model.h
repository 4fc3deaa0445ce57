// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "gestalt/core/base/export.h"

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

}  // namespace gestalt
