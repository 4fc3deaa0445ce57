// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace gestalt {

/// Angle between two vectors in [0, pi], exact for small and for nearly opposite ones; 0 when one is the zero vector.
inline float angle_between(const Eigen::Vector3f& x, const Eigen::Vector3f& y) {
  return std::atan2(x.cross(y).norm(), x.dot(y));
}

}  // namespace gestalt
