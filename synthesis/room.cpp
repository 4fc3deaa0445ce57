// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "room.h"

#include <algorithm>
#include <cmath>

#include "degree.h"
#include "shapes.h"

namespace gestalt::synthesis {

namespace {

/// Lacquer, cloth, concrete, wood.
Texture surface(double width, double height, Random& random) {
  if (random.chance(0.55)) return wood(width, height, random);
  Palette palette = random_palette(random);
  // Mostly duller than what stands on it.
  const double grey = random.uniform(40, 200), share = random.chance(0.8) ? random.uniform(0.5, 0.9) : 0.0;
  for (cv::Vec3b* colour : {&palette.ground, &palette.accent})
    for (int c = 0; c < 3; ++c) (*colour)[c] = uchar((1 - share) * (*colour)[c] + share * grey);
  return glaze(width, height, palette, random);
}

Body sheet(const Eigen::Vector3d& corner, const Eigen::Vector3d& u_edge, const Eigen::Vector3d& v_edge,
           const Texture& texture) {
  Mesh mesh;
  add_sheet(
      mesh, [=](double u, double v) -> Eigen::Vector3d { return corner + u * u_edge + v * v_edge; }, 1, 1,
      {u_edge.norm(), v_edge.norm()}, 0);
  return made_of(std::move(mesh), {texture});
}

/// Floor, walls and things as large as cupboards. back: y of the wall behind; clear: radius around the origin that
/// stays free of them.
void enclose(std::vector<Body>& furniture, double floor, double back, double clear, Random& random) {
  constexpr double height = 3, depth = 9;
  const double left = -random.uniform(1.6, 4), right = random.uniform(1.6, 4);
  const Eigen::Vector3d across(right - left, 0, 0), away(0, depth, 0), down(0, 0, -height);
  furniture.push_back(sheet({left, back - depth, floor}, across, away, surface(1.2, 1.2, random)));
  furniture.push_back(sheet({left, back, floor + height}, across, down, room(across.x(), height, random)));
  furniture.push_back(sheet({left, back - depth, floor + height}, away, down, room(depth, height, random)));
  furniture.push_back(sheet({right, back - depth, floor + height}, away, down, room(depth, height, random)));
  for (int i = random.integer(1, 8); i > 0; --i) {
    const Eigen::Vector3d size{random.uniform(0.25, 1.2), random.uniform(0.2, 0.7), random.uniform(0.3, 1.9)};
    const Eigen::Vector2d at{random.uniform(left, right), random.uniform(0, back)};
    if (at.norm() < clear + size.head<2>().norm() / 2) continue;
    Body box_there = block({at.x() - size.x() / 2, at.y() - size.y() / 2, floor}, size, surface(1, 1, random));
    furniture.push_back(std::move(box_there));
  }
}

}  // namespace

Body block(const Eigen::Vector3d& low, const Eigen::Vector3d& size, const Texture& texture) {
  Body body = made_of(box(size), {texture});
  body.pose.translation() = low + Eigen::Vector3d(size.x() / 2, size.y() / 2, 0);
  return body;
}

Room random_room(Random& random) {
  Room room;
  const bool on_floor = random.chance(0.15), at_wall = !on_floor && random.chance(0.25);
  room.yaw = at_wall ? 0 : degree * random.uniform(-25, 25);
  const auto half = [&](double least) { return on_floor ? random.uniform(1.2, 1.6) : random.uniform(least, 0.9); };
  room.top = {Eigen::Vector2d{-half(0.32), -half(0.3)}, Eigen::Vector2d{half(0.32), half(0.28)}};
  const Eigen::Vector2d size = room.top.sizes();
  const bool counter = !on_floor && random.chance(0.25);  // closed down to the floor
  const double height = on_floor ? 0.01 : random.uniform(0.4, 0.9);
  const double thickness = on_floor ? 0.01 : counter ? height : random.uniform(0.015, 0.05);
  const Eigen::Isometry3d turned(Eigen::AngleAxisd(room.yaw, Eigen::Vector3d::UnitZ()));
  const auto place = [&](Body body) {
    body.pose = turned * body.pose;
    return body;
  };
  const Texture paint = surface(size.x(), size.y(), random);
  room.table =
      place(block({room.top.min().x(), room.top.min().y(), -thickness}, {size.x(), size.y(), thickness}, paint));
  if (!on_floor && !counter) {
    const double leg = random.uniform(0.03, 0.08), inset = random.uniform(0, 0.1);
    for (const double x : {room.top.min().x() + inset, room.top.max().x() - inset - leg})
      for (const double y : {room.top.min().y() + inset, room.top.max().y() - inset - leg})
        room.furniture.push_back(place(block({x, y, -height}, {leg, leg, height - thickness}, paint)));
  }
  const double reach = std::max(room.top.min().norm(), room.top.max().norm());
  const double back = at_wall ? room.top.max().y() + random.uniform(0, 0.15) : reach + random.uniform(0.3, 3.5);
  enclose(room.furniture, -height, back, reach + 0.05, random);
  return room;
}

Room room_around_board(const Eigen::Vector2d& size, Random& random) {
  Room room;
  room.yaw = 0;
  room.top = {Eigen::Vector2d(-size / 2), Eigen::Vector2d(size / 2)};
  const double thickness = random.uniform(0.008, 0.03);
  room.table = block({-size.x() / 2, -size.y() / 2, -thickness}, {size.x(), size.y(), thickness},
                     surface(size.x(), size.y(), random));
  enclose(room.furniture, -random.uniform(0.7, 1.5), size.y() / 2 + random.uniform(0.01, 0.3), size.norm(), random);
  return room;
}

}  // namespace gestalt::synthesis
