// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

namespace gestalt::synthesis {

/// The upper side of everything on the table, over the world's x-y plane: what a falling thing lands on. The table is
/// z = 0 and goes on for ever.
class HeightField {
 public:
  HeightField();

  double at(float x, float y) const;

  /// Raises the field to points on a surface, in the world, at most 2.8 mm apart (else cells are missed).
  void add(std::span<const Eigen::Vector3f> points);

  /// The z at which the origin of a thing comes to rest that falls straight down at (x, y) in this orientation.
  /// points: of its surface, in its own frame.
  double resting_height(std::span<const Eigen::Vector3f> points, const Eigen::Matrix3d& orientation, double x,
                        double y) const;

 private:
  std::vector<float> heights_;
};

/// The pose in which a thing rests that falls at (x, y) from an orientation: it tilts about where it stands until its
/// centre of mass gets no lower, without rolling or sliding away.
/// swing (degrees): how far it carries over a ridge that it would have to climb; 4 leaves upright things standing.
Eigen::Isometry3d settle(const HeightField& field, std::span<const Eigen::Vector3f> points,
                         const Eigen::Vector3d& centre_of_mass, const Eigen::Matrix3d& orientation, double x, double y,
                         double swing);

}  // namespace gestalt::synthesis
