// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <vector>

#include "body.h"
#include "height_field.h"
#include "random.h"
#include "viewpoint.h"

namespace gestalt::synthesis {

/// A table that is being laid. Each way of placing tries several times and is false, with nothing changed, when the
/// thing would hang over the table's edge, leave the image, or leave it or another thing in view with fewer than
/// `smallest` pixels.
class Tabletop {
 public:
  /// table: rectangle of the table top in the frame `pose`; working_radius: things are put so near the origin (metres).
  /// least_inside: share of a thing that the image holds.
  Tabletop(const Viewpoint& viewpoint, const Eigen::AlignedBox2d& table, double table_yaw, double smallest,
           double working_radius, double least_inside = 0.98);

  /// On the bare table at this place. orientation turns the thing out of its standing pose.
  bool stand_at(const Body& body, const Eigen::Matrix3d& orientation, const Eigen::Vector2d& at);

  /// Somewhere on the bare table, touching nothing; lying on the side for 1 in 5 when it may.
  bool stand_free(const Body& body, Random& random, bool may_lie);

  /// On the bare table, pushed against a thing that is there.
  bool stand_beside(const Body& body, Random& random);

  /// On top of a thing, its centre within that thing's outline; offset 0 = centred, 1 = up to the edge.
  bool stand_on(const Body& body, int support, double offset, Random& random);

  /// Dropped in any orientation onto whatever is there.
  bool tumble(const Body& body, Random& random);

  /// Where its pose says.
  bool put(const Body& body);

  /// Background that hides things and that things fall onto: the walls of a bin, the boards of a shelf.
  void furnish(const Body& body);

  const std::vector<Body>& bodies() const { return bodies_; }
  const Preview& preview() const { return preview_; }

 private:
  struct Points {
    std::vector<Eigen::Vector3f> coarse, fine;  // own frame
    Eigen::Vector3d centre_of_mass;
  };
  static Points points_of(const Body& body);
  bool place(const Body& body, const Points& points, const Eigen::Isometry3d& pose);
  bool drop(const Body& body, const Points& points, const Eigen::Matrix3d& orientation, const Eigen::Vector2d& at,
            double swing);
  Eigen::Vector2d random_spot(Random& random) const;

  Eigen::AlignedBox2d table_;
  Eigen::Rotation2Dd to_table_;
  double smallest_, working_radius_, least_inside_;
  HeightField field_;
  Preview preview_;
  std::vector<Body> bodies_;
};

}  // namespace gestalt::synthesis
