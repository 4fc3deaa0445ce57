// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <vector>

#include "gestalt/core/scene/boundary_lines.h"
#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// A closed convex contour over the boundary lines of two or more surfaces (paper, Section 6). It turns to the left,
/// once around, and does not cross itself.
struct Closure {
  /// What a surface has of a closure.
  struct Part {
    int surface;
    float line_length;  ///< px, of the surface's lines in the closure, > 0
    float inside;       ///< share of the surface's pixels that the closure encloses, in [0, 1]
  };

  std::vector<int> lines;                ///< indices into BoundaryLines::lines, in order, the surfaces on the left
  std::vector<Eigen::Vector2f> outline;  ///< px; the ends of these lines: a polygon
  float line_length;                     ///< px, sum over the lines
  float gap_length;                      ///< px, sum over the links' gaps, at most twice line_length
  float cost;                            ///< sum of the links' costs, see LineLink
  std::vector<Part> parts;               ///< ascending surfaces with a line in the closure; two or more
};

/// For each of the 256 cheapest links between lines of two surfaces, the cheapest closure through it (Dijkstra over the
/// links; at most 256 lines are visited, and a closure has at most 24). Each closure is given once, cheapest first.
/// Deterministic for any number of threads.
GESTALT_EXPORT std::vector<Closure> find_closures(const Frame& frame, const SurfaceSet& surfaces,
                                                  const BoundaryLines& lines);

}  // namespace gestalt
