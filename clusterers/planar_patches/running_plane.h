// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <cmath>

namespace gestalt {

/// Mean point and mean normal of a set of pixels to which more are added.
struct RunningPlane {
  Eigen::Vector3d point_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  double count = 0;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();  ///< unit; (0, 0, 0) when the normals cancel out
  float offset = 0;                                  ///< normal . p + offset = 0 on the plane

  /// Takes a pixel in; normal and offset are of no use before the next update().
  void sum(const Eigen::Vector3f& point, const Eigen::Vector3f& n) {
    point_sum += point.cast<double>();
    normal_sum += n.cast<double>();
    count += 1;
  }
  /// The same for the pixels of another plane.
  void add(const RunningPlane& other) {
    point_sum += other.point_sum;
    normal_sum += other.normal_sum;
    count += other.count;
  }
  void update() {
    const Eigen::Vector3d direction = normal_sum.normalized();
    normal = direction.cast<float>();
    offset = -float(direction.dot(point_sum) / count);
  }
  float distance(const Eigen::Vector3f& p) const { return std::abs(normal.dot(p) + offset); }
};

}  // namespace gestalt
