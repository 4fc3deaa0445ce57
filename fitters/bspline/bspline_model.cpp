// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "bspline_model.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>

#include "closest_point.h"

namespace gestalt {

SurfaceModel::Foot BsplineModel::foot(const Eigen::Vector3f& p) const {
  const Eigen::Vector3d query = p.cast<double>();
  const Eigen::Vector2d at = closest_point(surface_, query, frame_.parameters(query)).parameters;
  const BsplineSurface::Derivatives s = surface_.derivatives(at.x(), at.y());
  Eigen::Vector3d normal = s.xi.cross(s.eta);
  // Where the surface is pinched to a line it has no normal of its own.
  normal = normal.norm() > 1e-9 * s.xi.norm() * s.eta.norm() ? normal.normalized() : frame_.normal;
  if (normal.dot(s.point) > 0) normal = -normal;
  return {s.point.cast<float>(), normal.cast<float>()};
}

float BsplineModel::squared_distance(const Eigen::Vector3f& p) const {
  const Eigen::Vector3d query = p.cast<double>();
  const double squared = closest_point(surface_, query, frame_.parameters(query)).squared_distance;
  return float(std::min(squared, double(std::numeric_limits<float>::max())));
}

std::optional<Eigen::Vector2d> BsplineModel::parameters(const Eigen::Vector3f& p) const {
  const Eigen::Vector3d query = p.cast<double>();
  return closest_point(surface_, query, frame_.parameters(query)).parameters;
}

nlohmann::json BsplineModel::to_json() const {
  nlohmann::json rows = nlohmann::json::array();
  for (int j = 0; j < surface_.rows(); ++j) {
    nlohmann::json row = nlohmann::json::array();
    for (int i = 0; i < surface_.columns(); ++i) {
      const Eigen::Vector3d& p = surface_.control_point(i, j);
      row.push_back({float(p.x()), float(p.y()), float(p.z())});
    }
    rows.push_back(std::move(row));
  }
  return {{"type", "bspline"},
          {"degree", surface_.degree},
          {"knots_xi", surface_.knots_xi},
          {"knots_eta", surface_.knots_eta},
          {"control_points", std::move(rows)}};
}

}  // namespace gestalt
