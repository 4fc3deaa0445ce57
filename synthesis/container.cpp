// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "container.h"

#include <algorithm>

#include "room.h"
#include "shapes.h"

namespace gestalt::synthesis {

namespace {

/// A flap of cardboard that hangs outward from the upper edge of a wall. heading: rad, where it points.
Body flap(double reach, double width, double height, double heading, double length, double down,
          const Texture& texture) {
  Body body = made_of(box({length, width, 0.004}), {texture});
  body.pose = Eigen::AngleAxisd(heading, Eigen::Vector3d::UnitZ()) * Eigen::Translation3d(reach, 0, height) *
              Eigen::AngleAxisd(down, Eigen::Vector3d::UnitY()) * Eigen::Translation3d(length / 2, 0, 0);
  return body;
}

}  // namespace

std::vector<Body> bin(const Eigen::Vector3d& inner, const Eigen::Isometry3d& pose, Random& random) {
  const double wall = random.uniform(0.003, 0.015), x = inner.x() / 2, y = inner.y() / 2, h = inner.z();
  const double low = -container_floor;
  const bool cardboard = random.chance(0.4);
  Palette palette = random_palette(random);
  if (cardboard) palette.ground = {110, 150, 180};
  if (!cardboard && random.chance(0.4)) palette.ground = cv::Vec3b::all(uchar(random.integer(170, 225)));
  const Texture paint = glaze(0.4, 0.4, palette, random);
  const Eigen::Vector3d along(2 * (x + wall), wall, h - low), across(wall, 2 * y, h - low);
  std::vector<Body> walls{block({-x, -y, low}, {2 * x, 2 * y, container_floor}, paint),
                          block({-x - wall, -y - wall, low}, along, paint), block({-x - wall, y, low}, along, paint),
                          block({-x - wall, -y, low}, across, paint), block({x, -y, low}, across, paint)};
  if (cardboard && random.chance(0.6)) {
    const double length = random.uniform(0.4, 0.5) * std::min(inner.x(), inner.y());
    for (int side = 0; side < 4; ++side)
      if (random.chance(0.7)) {
        const bool left_or_right = side % 2 == 0;
        const double reach = (left_or_right ? x : y) + wall / 2, width = 2 * (left_or_right ? y : x);
        walls.push_back(flap(reach, width, h, turn / 4 * side, length, random.uniform(-0.4, 1.2), paint));
      }
  }
  for (Body& body : walls) body.pose = pose * body.pose;
  return walls;
}

std::vector<Body> shelf(const Eigen::Vector2d& size, double above, Random& random) {
  const double x = size.x() / 2, y = size.y() / 2, wall = random.uniform(0.01, 0.03);
  const double low = -random.uniform(0.02, 0.4), high = above > 0 ? above + random.uniform(0, 0.3) : 0.5;
  const Texture paint = random.chance(0.5) ? wood(0.5, 0.5, random) : glaze(0.5, 0.5, random_palette(random), random);
  std::vector<Body> boards;
  if (random.chance(0.8)) boards.push_back(block({-x, y, low}, {2 * x, 0.006, high - low}, paint));
  for (const double side : {-x - wall, x})
    if (random.chance(0.75)) boards.push_back(block({side, -y, low}, {wall, 2 * y, high - low}, paint));
  if (above > 0) boards.push_back(block({-x, -y, above}, {2 * x, 2 * y, 0.02}, paint));
  return boards;
}

}  // namespace gestalt::synthesis
