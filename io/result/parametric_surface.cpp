// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/io/result/parametric_surface.h"

namespace gestalt {

namespace {

/// Numbers that describe a shape.
std::size_t numbers(const PlaneSurface&) { return 9; }
std::size_t numbers(const BsplineSurface& s) {
  return 1 + s.knots_xi.size() + s.knots_eta.size() + 3 * s.points.size();
}

Eigen::Vector3d point_of(const PlaneSurface& s, const Eigen::Vector2d& p) {
  return s.centre + p.x() * s.across + p.y() * s.down;
}
Eigen::Vector3d point_of(const BsplineSurface& s, const Eigen::Vector2d& p) { return s.point(p.x(), p.y()); }

}  // namespace

Eigen::Vector3d TrimmedSurface::point(const Eigen::Vector2d& parameters) const {
  return std::visit([&](const auto& s) { return point_of(s, parameters); }, shape);
}

std::size_t TrimmedSurface::bytes() const {
  std::size_t count = std::visit([](const auto& s) { return numbers(s); }, shape);
  for (const TrimmingOutline& outline : outlines)
    count += 1 + 2 * outline.vertices.size();  // one: how many, and if a hole
  return 4 * count;
}

}  // namespace gestalt
