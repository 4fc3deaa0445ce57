// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <vector>

namespace gestalt::synthesis {

struct Vertex {
  Eigen::Vector3f position;  ///< metres
  Eigen::Vector3f normal;    ///< unit; which side it points to is not defined
  Eigen::Vector2f texture;   ///< metres along the surface
};

struct Triangle {
  std::array<int, 3> corners;
  int part;  ///< which texture of the paint it wears
};

/// A surface of triangles. Vertices are not shared across creases.
struct Mesh {
  std::vector<Vertex> vertices;
  std::vector<Triangle> triangles;
};

/// A point of a smooth parametric sheet, u and v in [0, 1]. It is also evaluated slightly outside for the normals.
using Sheet = std::function<Eigen::Vector3d(double u, double v)>;

/// Adds a sheet cut into columns x rows cells. extent gives the metres that u and v run over in the texture.
void add_sheet(Mesh& mesh, const Sheet& sheet, int columns, int rows, const Eigen::Vector2d& extent, int part);

/// Points all over the surface, at most spacing (metres) apart along the two edges from a triangle's first corner; all
/// vertices are among them.
std::vector<Eigen::Vector3f> sample_surface(const Mesh& mesh, double spacing);

}  // namespace gestalt::synthesis
