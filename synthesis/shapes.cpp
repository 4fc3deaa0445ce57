// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "shapes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace gestalt::synthesis {

namespace {

constexpr int segments = 48;  // of a full turn: a radius of 10 cm is met within 0.2 mm

Sheet rectangle(const Eigen::Vector3d& corner, const Eigen::Vector3d& u_edge, const Eigen::Vector3d& v_edge) {
  return [=](double u, double v) -> Eigen::Vector3d { return corner + u * u_edge + v * v_edge; };
}

void add_rectangle(Mesh& mesh, const Eigen::Vector3d& corner, const Eigen::Vector3d& u_edge,
                   const Eigen::Vector3d& v_edge, int part) {
  add_sheet(mesh, rectangle(corner, u_edge, v_edge), 1, 1, {u_edge.norm(), v_edge.norm()}, part);
}

double signed_power(double base, double exponent) { return std::copysign(std::pow(std::abs(base), exponent), base); }

}  // namespace

Mesh box(const Eigen::Vector3d& size) {
  const double x = size.x() / 2, y = size.y() / 2, z = size.z();
  const Eigen::Vector3d ex(size.x(), 0, 0), ey(0, size.y(), 0), ez(0, 0, z);
  Mesh mesh;
  add_rectangle(mesh, {-x, -y, z}, ex, -ez, 0);
  add_rectangle(mesh, {x, y, z}, -ex, -ez, 1);
  add_rectangle(mesh, {-x, y, z}, -ey, -ez, 2);
  add_rectangle(mesh, {x, -y, z}, ey, -ez, 3);
  add_rectangle(mesh, {-x, y, z}, ex, -ey, 4);
  add_rectangle(mesh, {-x, -y, 0}, ex, ey, 5);
  return mesh;
}

Profile line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return [=](double t) -> Eigen::Vector2d { return from + t * (to - from); };
}

Mesh revolution(const std::vector<Profile>& pieces) {
  Mesh mesh;
  for (std::size_t part = 0; part < pieces.size(); ++part) {
    const Profile& profile = pieces[part];
    double length = 0, radius = 0, bend = 0;
    constexpr int steps = 8;
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d a = profile(double(i) / steps), b = profile(double(i + 1) / steps);
      length += (b - a).norm();
      radius = std::max({radius, a.x(), b.x()});
      bend = std::max(bend, (profile((i + 0.5) / steps) - (a + b) / 2).norm());
    }
    const auto sheet = [&](double u, double v) -> Eigen::Vector3d {
      const Eigen::Vector2d point = profile(v);
      return {point.x() * std::sin(turn * u), -point.x() * std::cos(turn * u), point.y()};
    };
    add_sheet(mesh, sheet, segments, bend > 1e-6 ? 2 * steps : 1, {turn * radius, length}, int(part));
  }
  return mesh;
}

Mesh cylinder(double radius, double height) { return cone(radius, radius, height); }

Mesh bowl(double radius, double foot_radius, double height, double wall) {
  const auto wall_of = [](double bottom, double top, double low, double high) -> Profile {
    return [=](double t) -> Eigen::Vector2d {
      const double angle = (1 - t) * turn / 4;  // from the rim down
      return {bottom + (top - bottom) * std::sin(angle), low + (high - low) * (1 - std::cos(angle))};
    };
  };
  return revolution({wall_of(foot_radius, radius, 0, height), wall_of(0, radius - wall, wall, height),
                     line({radius, height}, {radius - wall, height}), line({foot_radius, 0}, {0, 0})});
}

Mesh mug(double radius, double height, double wall, double handle_radius) {
  const double inner = radius - wall;
  Mesh mesh =
      revolution({line({radius, height}, {radius, 0}), line({inner, height}, {inner, wall}),
                  line({radius, height}, {inner, height}), line({inner, wall}, {0, wall}), line({radius, 0}, {0, 0})});
  constexpr double tube = 0.0055;
  const auto handle = [&](double u, double v) -> Eigen::Vector3d {
    const double along = turn * (v - 0.5) / 2, around = turn * u;
    const double ring = handle_radius + tube * std::cos(around);
    return {radius - wall / 2 + 0.85 * ring * std::cos(along), 1.3 * tube * std::sin(around),
            height / 2 + ring * std::sin(along)};
  };
  add_sheet(mesh, handle, 16, 20, {turn * tube, turn * handle_radius / 2}, 5);
  return mesh;
}

Mesh bottle(double radius, double height, double neck_radius) {
  const double body = 0.58 * height, shoulder = 0.78 * height, neck = 0.93 * height;
  const double cap = neck_radius + 0.002;
  const auto shoulder_profile = [=](double t) -> Eigen::Vector2d {
    const double blend = (1 - std::cos(turn / 2 * t)) / 2;
    return {neck_radius + (radius - neck_radius) * blend, shoulder + (body - shoulder) * t};
  };
  return revolution({line({radius, body}, {radius, 0}), shoulder_profile,
                     line({neck_radius, neck}, {neck_radius, shoulder}), line({cap, height}, {cap, neck}),
                     line({cap, height}, {0, height}), line({radius, 0}, {0, 0})});
}

Mesh cone(double bottom_radius, double top_radius, double height) {
  return revolution({line({top_radius, height}, {bottom_radius, 0}), line({top_radius, height}, {0, height}),
                     line({bottom_radius, 0}, {0, 0})});
}

Mesh superellipsoid(const Eigen::Vector3d& half_axes, double e1, double e2) {
  const auto sheet = [&](double u, double v) -> Eigen::Vector3d {
    const double longitude = turn * u, latitude = turn / 2 * (0.5 - v);
    const double ring = signed_power(std::cos(latitude), e1);
    return {half_axes.x() * ring * signed_power(std::sin(longitude), e2),
            -half_axes.y() * ring * signed_power(std::cos(longitude), e2),
            half_axes.z() * (1 + signed_power(std::sin(latitude), e1))};
  };
  Mesh mesh;
  add_sheet(mesh, sheet, segments, segments / 2, {turn * half_axes.head<2>().maxCoeff(), turn / 2 * half_axes.z()}, 0);
  return mesh;
}

Mesh extrusion(const std::vector<Eigen::Vector2d>& outline, double height) {
  Mesh mesh;
  double run = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d &a = outline[i], &b = outline[(i + 1) % outline.size()];
    const std::size_t first = mesh.vertices.size();
    const double length = (b - a).norm();
    add_rectangle(mesh, {a.x(), a.y(), height}, {b.x() - a.x(), b.y() - a.y(), 0}, {0, 0, -height}, 0);
    for (std::size_t j = first; j < mesh.vertices.size(); ++j) mesh.vertices[j].texture.x() += float(run);
    run += length;
    for (const int part : {1, 2}) {
      const float z = part == 1 ? float(height) : 0.f;
      const int corner = int(mesh.vertices.size());
      for (const Eigen::Vector2d& p : {Eigen::Vector2d(0, 0), a, b})
        mesh.vertices.push_back({{float(p.x()), float(p.y()), z}, Eigen::Vector3f::UnitZ(), p.cast<float>()});
      mesh.triangles.push_back({{corner, corner + 1, corner + 2}, part});
    }
  }
  return mesh;
}

Mesh pillow(const Eigen::Vector3d& size) {
  const double seam = 0.25 * size.z();  // height at which top and bottom meet
  const auto bulge = [](double u, double v) {
    const auto across = [](double t) { return std::max(0.0, 1 - std::pow(std::abs(2 * t - 1), 4)); };
    return std::sqrt(across(u) * across(v));
  };
  Mesh mesh;
  const auto top = [&](double u, double v) -> Eigen::Vector3d {
    return {(u - 0.5) * size.x(), (0.5 - v) * size.y(), seam + (size.z() - seam) * bulge(u, v)};
  };
  const auto bottom = [&](double u, double v) -> Eigen::Vector3d {
    return {(u - 0.5) * size.x(), (v - 0.5) * size.y(), seam * (1 - bulge(u, v))};
  };
  constexpr int cells = 20;
  add_sheet(mesh, top, cells, cells, size.head<2>(), 0);
  add_sheet(mesh, bottom, cells, cells, size.head<2>(), 1);
  return mesh;
}

Mesh pouch(const Eigen::Vector3d& size) {
  Mesh mesh;
  // u along the width; v from the top down. Sides are seams: the depth goes to nothing there.
  const auto half_depth = [&](double u, double v) {
    const double across = std::sqrt(std::max(0.0, 1 - std::pow(std::abs(2 * u - 1), 4)));
    return size.y() / 2 * across * std::sqrt(std::clamp(v, 0.0, 1.0));
  };
  const auto front = [&](double u, double v) -> Eigen::Vector3d {
    return {(u - 0.5) * size.x(), -half_depth(u, v), (1 - v) * size.z()};
  };
  const auto back = [&](double u, double v) -> Eigen::Vector3d {
    return {(0.5 - u) * size.x(), half_depth(u, v), (1 - v) * size.z()};
  };
  const auto bottom = [&](double u, double v) -> Eigen::Vector3d {
    return {(u - 0.5) * size.x(), (2 * v - 1) * half_depth(u, 1), 0};
  };
  constexpr int cells = 20;
  add_sheet(mesh, front, cells, cells, {size.x(), size.z()}, 0);
  add_sheet(mesh, back, cells, cells, {size.x(), size.z()}, 1);
  add_sheet(mesh, bottom, cells, 2, size.head<2>(), 2);
  return mesh;
}

void join(Mesh& mesh, const Mesh& other, const Eigen::Isometry3d& pose, int first_part) {
  const int first = int(mesh.vertices.size());
  const Eigen::Isometry3f moved = pose.cast<float>();
  for (Vertex vertex : other.vertices) {
    vertex.position = moved * vertex.position;
    vertex.normal = moved.linear() * vertex.normal;
    mesh.vertices.push_back(vertex);
  }
  for (Triangle triangle : other.triangles) {
    for (int& corner : triangle.corners) corner += first;
    triangle.part += first_part;
    mesh.triangles.push_back(triangle);
  }
}

}  // namespace gestalt::synthesis
