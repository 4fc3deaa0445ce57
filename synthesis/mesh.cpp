// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gestalt::synthesis {

namespace {

Eigen::Vector3d normal_of(const Sheet& sheet, double u, double v) {
  constexpr double step = 1e-4;
  const auto normal_at = [&](double s, double t) -> Eigen::Vector3d {
    return (sheet(s + step, t) - sheet(s - step, t)).cross(sheet(s, t + step) - sheet(s, t - step));
  };
  Eigen::Vector3d normal = normal_at(u, v);
  // At a pole, where all u are one point, the normal is that of a point just beside it.
  if (normal.norm() < 1e-14) normal = normal_at(u, v < 0.5 ? v + 10 * step : v - 10 * step);
  return normal.norm() > 0 ? Eigen::Vector3d(normal.normalized()) : Eigen::Vector3d::UnitZ();
}

}  // namespace

void add_sheet(Mesh& mesh, const Sheet& sheet, int columns, int rows, const Eigen::Vector2d& extent, int part) {
  const int first = int(mesh.vertices.size());
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) {
      const double u = double(i) / columns, v = double(j) / rows;
      mesh.vertices.push_back({sheet(u, v).cast<float>(), normal_of(sheet, u, v).cast<float>(),
                               Eigen::Vector2d(u * extent.x(), v * extent.y()).cast<float>()});
    }
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int corner = first + j * (columns + 1) + i, opposite = corner + columns + 2;
      mesh.triangles.push_back({{corner, corner + 1, opposite - 1}, part});
      mesh.triangles.push_back({{opposite, opposite - 1, corner + 1}, part});
    }
}

std::vector<Eigen::Vector3f> sample_surface(const Mesh& mesh, double spacing) {
  std::vector<Eigen::Vector3f> samples;
  for (const Triangle& triangle : mesh.triangles) {
    const Eigen::Vector3f& corner = mesh.vertices[std::size_t(triangle.corners[0])].position;
    const Eigen::Vector3f a = mesh.vertices[std::size_t(triangle.corners[1])].position - corner;
    const Eigen::Vector3f b = mesh.vertices[std::size_t(triangle.corners[2])].position - corner;
    const int columns = std::max(1, int(std::ceil(a.norm() / spacing)));
    const int rows = std::max(1, int(std::ceil(b.norm() / spacing)));
    for (int i = 0; i <= columns; ++i)
      for (int j = 0; i * rows + j * columns <= rows * columns; ++j)
        samples.push_back(corner + a * (float(i) / float(columns)) + b * (float(j) / float(rows)));
  }
  return samples;
}

}  // namespace gestalt::synthesis
