// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <variant>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/bspline_surface.h"

namespace gestalt {

/// A plane with parameters in metres: the point of (a, b) is centre + a * across + b * down.
struct PlaneSurface {
  Eigen::Vector3d centre;
  Eigen::Vector3d across;  ///< unit
  Eigen::Vector3d down;    ///< unit, perpendicular to across
};

/// A closed polygon in the parameters of a surface.
struct TrimmingOutline {
  bool hole = false;
  std::vector<Eigen::Vector2d> vertices;
};

/// A surface as result.json has it: its shape and the part of it that was seen.
struct GESTALT_EXPORT TrimmedSurface {
  std::variant<PlaneSurface, BsplineSurface> shape;
  std::vector<TrimmingOutline> outlines;
  std::size_t points = 0;  ///< that it was fitted to
  double rms = 0;          ///< m, of their distances to it

  Eigen::Vector3d point(const Eigen::Vector2d& parameters) const;

  /// Bytes that it takes with 4 bytes a number: shape and outlines.
  std::size_t bytes() const;
};

struct Mesh {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<std::array<int, 3>> triangles;  ///< indices of vertices
};

/// What triangles of the surfaces of one file may still cost, together: far above what any scene needs, so that a file
/// made to do harm ends in an error within seconds, whatever the number of its patches.
struct TriangulationBudget {
  static constexpr std::size_t most_tests = 500'000'000, most_triangles = 1'000'000;

  std::size_t tests = most_tests;          ///< of an outline's vertex with what may lie around it
  std::size_t triangles = most_triangles;  ///< that are given
};

/// The triangles of polygons with holes, as indices into the vertices of all outlines, one after the other. They have
/// one orientation (positive area) and cover exactly the polygons where these do not cross themselves; a hole outside
/// of all polygons is left out, and so is what has no area. Throws InputError when the outlines are hopelessly tangled:
/// the budget's tests do not suffice.
GESTALT_EXPORT std::vector<std::array<int, 3>> triangulate(const std::vector<TrimmingOutline>& outlines,
                                                           TriangulationBudget& budget);

/// The part of a surface within its outlines, as triangles whose edges are no farther than tolerance (m) from it.
/// Throws InputError when the budget does not suffice.
GESTALT_EXPORT Mesh triangulate(const TrimmedSurface& surface, double tolerance, TriangulationBudget& budget);

}  // namespace gestalt
