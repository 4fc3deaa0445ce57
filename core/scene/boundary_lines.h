// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gestalt/core/scene/contour.h"
#include "gestalt/core/scene/frame.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// What is seen just beyond a boundary line, on the other side than its surface.
enum class Beyond {
  farther,    ///< something farther away: the line is where the surface ends
  level,      ///< something as far away: the surface ends, or it meets the next one in a crease
  nothing,    ///< no depth
  nearer,     ///< something nearer hides where the surface ends: the line is the occluder's, not the surface's own
  image_edge  ///< the image ends, not the surface
};

/// A straight piece of a surface's contour (paper, Section 6). Its surface lies on the left as one walks from the first
/// to the second end with the image upright, so an outer contour runs counter-clockwise.
struct BoundaryLine {
  int surface;
  std::array<Eigen::Vector2f, 2> ends;  ///< px, on the line fitted to the contour pixels
  std::array<Eigen::Vector3f, 2>
      points;                 ///< m, camera frame, on the line fitted to these pixels' points on the surface
  Eigen::Vector2f direction;  ///< unit, in the image, from the first to the second end
  float length;               ///< px, between the ends
  int support;                ///< contour pixels that it was fitted to, >= 2
  Beyond beyond;

  /// The surface itself ends here, as far as can be seen.
  bool own() const { return beyond != Beyond::nearer && beyond != Beyond::image_edge; }
};

/// Where the search line along the second end of one line meets that of the first end of another: going on from one to
/// the other, the surfaces of both stay on the left.
struct LineLink {
  int from;
  int to;
  float turn;  ///< rad, in (-pi, pi]; > 0 to the left, as around a convex surface
  float gap;   ///< px, from end to end: in the image, or in 3D at the focal length and depth where that is longer
  float cost;  ///< in [0, 1): how likely such a link is by chance, among so many lines in so large an image
  Eigen::Vector2f meeting;  ///< px; a junction's corner, a collinearity's middle
};

/// A line was cut in two here because another line ends on it, in the image and in 3D.
struct TJunction {
  Eigen::Vector2f at;  ///< px
};

/// The straight boundaries of an image and how they go on in each other. Only own() lines have links. Sorted by
/// length, the longest first: numbers do not depend on those of the surfaces.
struct BoundaryLines {
  std::vector<BoundaryLine> lines;
  std::vector<LineLink> junctions;       ///< L-junctions: left or right turns of 30 degrees and more; by (from, cost)
  std::vector<LineLink> collinearities;  ///< less than that; by (from, cost)
  std::vector<TJunction> t_junctions;
};

/// Lines fitted to contours that are split where they deviate most, until a line fits them within 1.9 px; 8 px at
/// least; search lines from their ends, longer lines searching farther; lines met in their middle are split. Pixel
/// lengths are for a focal length of 525 px and grow with it. At most the 1500 longest lines are kept and the 12 best
/// links from each, which bounds the work. Deterministic for any number of threads.
GESTALT_EXPORT BoundaryLines find_boundary_lines(const Frame& frame, const SurfaceSet& surfaces,
                                                 const std::vector<std::vector<Contour>>& contours);

}  // namespace gestalt
