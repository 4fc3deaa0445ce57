// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "body.h"
#include "embree.h"

namespace gestalt::synthesis {

/// Where a ray first meets a surface.
struct Hit {
  int body = -1;  ///< number of the body in the order given; -1 = nothing is met, the rest is undefined
  int part = 0;
  float distance = 0;       ///< in lengths of the ray's direction
  Eigen::Vector3f normal;   ///< unit, world, turned against the ray
  Eigen::Vector2f texture;  ///< metres on the surface
};

/// Casts rays against bodies in their places, with Embree. Keeps references to the bodies.
class RayCaster {
 public:
  /// Throws Error when Embree cannot be set up.
  explicit RayCaster(std::vector<const Body*> bodies);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;

  Hit cast(const Eigen::Vector3f& origin, const Eigen::Vector3f& direction) const;

  /// Whether nothing lies between a point on a surface and another point. The last 3 mm before the surface do not
  /// count.
  bool visible(const Eigen::Vector3f& surface_point, const Eigen::Vector3f& from) const;

 private:
  void set_up();

  std::vector<const Body*> bodies_;
  RTCDevice device_ = nullptr;
  RTCScene scene_ = nullptr;
};

}  // namespace gestalt::synthesis
