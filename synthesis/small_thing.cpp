// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "small_thing.h"

#include "shapes.h"

namespace gestalt::synthesis {

namespace {

Eigen::Isometry3d moved(double x, double y, double z) { return Eigen::Isometry3d(Eigen::Translation3d(x, y, z)); }

/// A flat handle, and at its end a spoon's bowl or a broad blade.
Body cutlery(const Palette& palette, Random& random) {
  const double length = random.uniform(0.1, 0.2), width = random.uniform(0.009, 0.02);
  const double thickness = random.uniform(0.004, 0.01);
  Mesh mesh = box({length, width, thickness});
  if (random.chance(0.5)) {
    const double head = width * random.uniform(1, 1.5);
    join(mesh, superellipsoid({1.5 * head, head, random.uniform(0.4, 0.9) * thickness}, 1, 1),
         moved(length / 2 + head, 0, 0), 6);
  } else if (random.chance(0.5)) {
    join(mesh, box({0.6 * length, 1.5 * width, 0.5 * thickness}), moved(0.75 * length, 0.2 * width, 0), 6);
  }
  const Texture handle = plain(palette.ground);
  std::vector<Texture> parts(6, handle);
  parts.push_back(random.chance(0.5) ? handle : plain(palette.accent));
  return made_of(std::move(mesh), std::move(parts));
}

/// Lies along x.
Body rod(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.005, 0.014), length = random.uniform(0.06, 0.18);
  Mesh mesh;
  Eigen::Isometry3d lying = moved(-length / 2, 0, radius);
  lying.rotate(Eigen::AngleAxisd(turn / 4, Eigen::Vector3d::UnitY()));
  join(mesh, cone(radius, radius * random.uniform(0.7, 1), length), lying, 0);
  return made_of(std::move(mesh), {print(turn * radius, length, palette, random), plain(palette.band)});
}

Body thin_box(const Palette& palette, Random& random) {
  const Eigen::Vector3d size{random.uniform(0.06, 0.22), random.uniform(0.05, 0.15), random.uniform(0.005, 0.02)};
  return carton(size, palette, random);
}

Body cube(const Palette& palette, Random& random) {
  const double edge = random.uniform(0.018, 0.045);
  const double length = edge * (random.chance(0.5) ? 1 : random.uniform(1, 2));
  return made_of(box({length, edge, edge * random.uniform(0.6, 1)}),
                 {random.chance(0.5) ? plain(palette.ground) : print(length, edge, palette, random)});
}

Body ball(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.015, 0.032);
  return made_of(superellipsoid({radius * random.uniform(1, 1.7), radius, radius}, 1, 1),
                 {glaze(turn * radius, 3 * radius, palette, random)});
}

Body dish(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.05, 0.11), height = random.uniform(0.01, 0.025);
  return made_of(bowl(radius, radius * random.uniform(0.5, 0.7), height, 0.003),
                 {glaze(turn * radius, radius, palette, random)});
}

Body low_can(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.015, 0.05), height = random.uniform(0.008, 0.04);
  return made_of(cylinder(radius, height), {plain(palette.ground), print(2 * radius, 2 * radius, palette, random)});
}

}  // namespace

Body random_small_thing(const Palette& palette, Random& random) {
  using Make = Body (*)(const Palette&, Random&);
  static const Make makes[] = {cutlery,  cutlery, rod,  rod,  thin_box, thin_box,
                               thin_box, cube,    cube, ball, dish,     low_can};
  return random.pick(makes)(palette, random);
}

}  // namespace gestalt::synthesis
