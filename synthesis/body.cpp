// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "body.h"

#include <cmath>

#include "shapes.h"

namespace gestalt::synthesis {

namespace {

Eigen::Vector3d extent(const Mesh& mesh) {
  Eigen::Vector3f low = mesh.vertices.front().position, high = low;
  for (const Vertex& vertex : mesh.vertices) {
    low = low.cwiseMin(vertex.position);
    high = high.cwiseMax(vertex.position);
  }
  return (high - low).cast<double>();
}

Body can(const Palette& palette, Random& random) {
  static const double radii[] = {0.026, 0.033, 0.037, 0.042, 0.05, 0.075, 0.1};
  const double usual = random.pick(radii), radius = usual * random.uniform(0.92, 1.08);
  const double height = radius > 0.06 ? random.uniform(0.04, 0.1) : random.uniform(0.07, radius < 0.04 ? 0.2 : 0.24);
  const Texture side = random.chance(0.8) ? print(turn * radius, height, palette, random)
                                          : glaze(turn * radius, height, palette, random);
  const Texture lid = radius > 0.06 && random.chance(0.6)
                          ? print(turn * radius, radius, palette, random)
                          : plain(random.chance(0.5) ? cv::Vec3b(185, 185, 188) : palette.band);
  return made_of(cylinder(radius, height), {side, lid, lid});
}

Body hollow_bowl(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.055, 0.12);
  const double height = radius * random.uniform(0.45, 0.95);
  const Texture outside = glaze(turn * radius, height * 1.3, palette, random);
  const Texture inside =
      random.chance(0.6) ? outside : glaze(turn * radius, height * 1.3, random_palette(random), random);
  const double foot = radius * random.uniform(0.35, 0.6), wall = random.uniform(0.003, 0.006);
  return made_of(bowl(radius, foot, height, wall), {outside, inside, plain(palette.ground)});
}

Body hollow_mug(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.035, 0.048), height = random.uniform(0.08, 0.115);
  const bool printed = random.chance(0.4);
  const Texture outside =
      printed ? print(turn * radius, height, palette, random) : glaze(turn * radius, height, palette, random);
  const Texture inside = plain(random.chance(0.5) ? palette.ground : cv::Vec3b(215, 220, 220));
  const double wall = random.uniform(0.003, 0.005), handle = height * random.uniform(0.26, 0.33);
  return made_of(mug(radius, height, wall, handle), {outside, inside, inside, inside, plain(palette.ground)});
}

Body round_bottle(const Palette& palette, Random& random) {
  const double radius = random.uniform(0.028, 0.045), height = random.uniform(0.15, 0.27);
  const Texture bare = plain(palette.ground);
  const Texture label = print(turn * radius, 0.58 * height, palette, random);
  const double neck = radius * random.uniform(0.32, 0.5);
  return made_of(bottle(radius, height, neck), {label, bare, bare, plain(palette.accent)});
}

Body pebble(const Palette& palette, Random& random) {
  const Eigen::Vector3d half{random.uniform(0.03, 0.085), random.uniform(0.03, 0.07), random.uniform(0.025, 0.06)};
  const double along = random.uniform(0.35, 1.2), around = random.uniform(0.35, 1.3);
  return made_of(superellipsoid(half, along, around), {glaze(turn * half.x(), 3 * half.z(), palette, random)});
}

std::vector<Eigen::Vector2d> random_outline(Random& random) {
  const double reach = random.uniform(0.05, 0.11);
  if (random.chance(0.5)) {  // an L around the origin, which lies in its bend
    const double wide = random.uniform(0.02, 0.035), other = reach * random.uniform(0.7, 1.2);
    return {{-wide, -wide}, {1.6 * reach, -wide}, {1.6 * reach, wide},
            {wide, wide},   {wide, 1.6 * other},  {-wide, 1.6 * other}};
  }
  std::vector<Eigen::Vector2d> outline;
  const int corners = random.integer(3, 7);
  for (int i = 0; i < corners; ++i) {
    const double angle = turn * (i + random.uniform(-0.2, 0.2)) / corners, radius = reach * random.uniform(0.6, 1);
    outline.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  return outline;
}

Body prism(const Palette& palette, Random& random) {
  const double height = random.uniform(0.03, 0.13);
  const Texture side = random.chance(0.4) ? print(0.3, height, palette, random) : glaze(0.3, height, palette, random);
  const std::vector<Eigen::Vector2d> outline = random_outline(random);
  return made_of(extrusion(outline, height), {side, glaze(0.2, 0.2, palette, random)});
}

Body truncated_cone(const Palette& palette, Random& random) {
  const double bottom = random.uniform(0.035, 0.075), top = bottom * random.uniform(0, 0.8);
  const double height = random.uniform(0.08, 0.2);
  return made_of(cone(bottom, top, height), {glaze(turn * bottom, height, palette, random), plain(palette.band)});
}

Eigen::Vector3d random_carton_size(Random& random) {
  const double kind = random.uniform();
  if (kind < 0.35)  // cereal, rice, tea: upright and flat
    return {random.uniform(0.09, 0.2), random.uniform(0.035, 0.08), random.uniform(0.13, 0.29)};
  if (kind < 0.7)  // lying flat
    return {random.uniform(0.12, 0.27), random.uniform(0.09, 0.2), random.uniform(0.03, 0.08)};
  return {random.uniform(0.05, 0.14), random.uniform(0.05, 0.12), random.uniform(0.05, 0.14)};
}

}  // namespace

Body made_of(Mesh mesh, std::vector<Texture> parts) {
  const Eigen::Vector3d size = extent(mesh);
  return {std::move(mesh), {std::move(parts)}, size};
}

Body carton(const Eigen::Vector3d& size, const Palette& palette, Random& random) {
  const Eigen::Vector2d faces[] = {{size.x(), size.z()}, {size.y(), size.z()}, {size.x(), size.y()}};
  const bool bare = random.chance(0.2);  // plain cardboard, or a block in one colour
  std::vector<Texture> parts;
  for (const Eigen::Vector2d& face : faces)
    for (int side = 0; side < 2; ++side)
      parts.push_back(bare ? glaze(face.x(), face.y(), palette, random) : print(face.x(), face.y(), palette, random));
  Body made = made_of(box(size), std::move(parts));
  made.shape = ShapeKind::box;
  return made;
}

Body random_body(Kind kind, const Palette& palette, Random& random) {
  switch (kind) {
    case Kind::carton:
      return carton(random_carton_size(random), palette, random);
    case Kind::can: {
      Body made = can(palette, random);
      made.shape = ShapeKind::cylinder;
      return made;
    }
    case Kind::bowl:
      return hollow_bowl(palette, random);
    case Kind::mug:
      return hollow_mug(palette, random);
    case Kind::bottle:
      return round_bottle(palette, random);
    case Kind::cone:
      return truncated_cone(palette, random);
    case Kind::pebble:
      return pebble(palette, random);
    case Kind::prism:
      break;
  }
  return prism(palette, random);
}

}  // namespace gestalt::synthesis
