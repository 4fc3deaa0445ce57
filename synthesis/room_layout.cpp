// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "room_layout.h"

#include <algorithm>
#include <cmath>

#include "brands.h"
#include "container.h"
#include "degree.h"
#include "grocery.h"
#include "packing.h"
#include "repeat.h"
#include "room.h"
#include "small_thing.h"
#include "tabletop.h"

namespace gestalt::synthesis {

namespace {

Eigen::AngleAxisd about_z(double angle) { return {angle, Eigen::Vector3d::UnitZ()}; }

/// From where a category is looked at.
struct Framing {
  double nearest, farthest;   // metres to the things
  double flattest, steepest;  // degrees below the horizon
  double azimuth;             // degrees to either side
};

Framing framing_of(Category category) {
  switch (category) {
    case Category::packages:
      return {0.45, 2.2, 15, 88, 30};
    case Category::bin:
      return {0.45, 1.4, 50, 89, 180};
    case Category::thin_and_small:
      return {0.3, 0.9, 22, 88, 30};
    case Category::shelf:
      return {0.5, 1.6, 2, 28, 30};
    default:
      break;  // groceries
  }
  return {0.45, 2.0, 12, 80, 30};
}

Viewpoint look(const Camera& camera, const Framing& framing, Random& random) {
  // Near views are as frequent as far ones: the logarithm is uniform.
  const double distance = framing.nearest * std::pow(framing.farthest / framing.nearest, random.uniform());
  const double pitch = degree * random.uniform(framing.flattest, framing.steepest);
  const double roll = degree * (random.chance(0.25) ? random.uniform(-20, 20) : random.uniform(-3, 3));
  const double off = 0.06 * distance;
  const Eigen::Vector3d target{random.uniform(-off, off), random.uniform(-off, off), 0.05};
  const Eigen::Vector3d forward(0, std::cos(pitch), -std::sin(pitch));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), down = forward.cross(right);
  const auto around = about_z(degree * framing.azimuth * random.uniform(-1, 1)).toRotationMatrix();
  Viewpoint viewpoint{camera, Eigen::Isometry3d::Identity()};
  viewpoint.pose.linear() << right, down, forward;
  viewpoint.pose.linear() = around * viewpoint.pose.linear() * about_z(roll).toRotationMatrix();
  viewpoint.pose.translation() = around * (target - distance * forward);
  return viewpoint;
}

/// How far from the origin things are still seen, metres.
double reach_of(const Viewpoint& viewpoint) {
  const Camera& camera = viewpoint.camera;
  return 0.8 * viewpoint.pose.translation().norm() *
         std::min(camera.width / camera.fx / 2, 1.3 * camera.height / camera.fy / 2);
}

/// On something upright, not too high and about as wide.
bool stack(Tabletop& tabletop, const Body& body, Random& random) {
  std::vector<int> supports;
  for (int i = 0; i < int(tabletop.bodies().size()); ++i) {
    const Body& support = tabletop.bodies()[std::size_t(i)];
    if (support.pose.linear()(2, 2) > 0.99 && support.pose.translation().z() + support.size.z() < 0.2 &&
        support.size.head<2>().minCoeff() > 0.7 * body.size.head<2>().minCoeff())
      supports.push_back(i);
  }
  return !supports.empty() && tabletop.stand_on(body, random.pick(supports), random.chance(0.4) ? 0 : 0.4, random);
}

/// Weights of the ways of placing one more thing; what is left of 1 stands free.
struct Ways {
  double stacked, beside, dropped;
};

bool add_one(Tabletop& tabletop, const Body& body, const Ways& ways, Random& random) {
  const double way = tabletop.bodies().empty() ? 1 : random.uniform();
  if (way < ways.stacked) return stack(tabletop, body, random);
  if (way < ways.stacked + ways.beside) return tabletop.stand_beside(body, random);
  if (way < ways.stacked + ways.beside + ways.dropped) return tabletop.tumble(body, random);
  return tabletop.stand_free(body, random, true);
}

bool lay_packages(Tabletop& tabletop, double reach, Brands& brands, Random& random) {
  const double largest = std::min(0.55, 1.3 * reach);
  const Eigen::Vector2d half{random.uniform(0.3, 0.5) * largest, random.uniform(0.08, 0.4) * largest};
  const double yaw = degree * random.uniform(-180, 180);
  const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 0) * about_z(yaw));
  if (!pack(tabletop, {Eigen::Vector2d(-half), half}, pose, random.integer(1, 3), brands, random)) return false;
  return repeat_as_fits(random.integer(0, 5), 0, [&] {
    return add_one(tabletop, random_grocery(brands.next(), random), {0.35, 0.35, 0.1}, random);
  });
}

bool lay_groceries(Tabletop& tabletop, double reach, Brands& brands, Random& random) {
  const Ways ways = random.chance(0.4) ? Ways{0.1, 0.2, 0.5} : Ways{0.2, 0.3, 0.1};
  if (random.chance(0.3)) {
    const double half = std::min(0.9 * reach, 0.35);
    line_up(tabletop, -half, half, random.uniform(-0.1, 0.1), 0.15, 0.3, brands, random);
  }
  const int present = int(tabletop.bodies().size());
  return repeat_as_fits(std::max(1, random.integer(5, 18) - present), std::max(0, 4 - present),
                        [&] { return add_one(tabletop, random_grocery(brands.next(), random), ways, random); });
}

bool lay_small_things(Tabletop& tabletop, Brands& brands, Random& random) {
  return repeat_as_fits(random.integer(4, 14), 3, [&] {
    const Body body =
        random.chance(0.88) ? random_small_thing(brands.next(), random) : random_grocery(brands.next(), random);
    return add_one(tabletop, body, {0.15, 0.2, 0.15}, random);
  });
}

/// Things of at most this size.
Body fitting(double size, Brands& brands, Random& random) {
  for (int i = 0; i < 10; ++i) {
    const double kind = random.uniform();
    static const Kind kinds[] = {Kind::mug, Kind::bowl, Kind::pebble, Kind::prism, Kind::cone};
    Body body = kind < 0.55  ? random_grocery(brands.next(), random)
                : kind < 0.8 ? random_small_thing(brands.next(), random)
                             : random_body(random.pick(kinds), brands.next(), random);
    if (body.size.maxCoeff() < size) return body;
  }
  return random_small_thing(brands.next(), random);
}

bool lay_bin(Tabletop& tabletop, const Eigen::Vector3d& inner, const Eigen::Isometry3d& pose, Brands& brands,
             Random& random) {
  if (random.chance(0.25)) {  // parcels against a corner
    const Eigen::Vector2d corner = -inner.head<2>() / 2, size = inner.head<2>() * random.uniform(0.6, 0.99);
    return pack(tabletop, {corner, Eigen::Vector2d(corner + size)}, pose, random.integer(1, 2), brands, random);
  }
  const Ways ways = random.chance(0.5) ? Ways{0.05, 0.2, 0.65} : Ways{0.15, 0.3, 0.2};
  return repeat_as_fits(random.integer(3, 14), 2, [&] {
    return add_one(tabletop, fitting(random.uniform(0.4, 0.9) * inner.head<2>().minCoeff(), brands, random), ways,
                   random);
  });
}

bool lay_shelf(Tabletop& tabletop, const Eigen::Vector2d& size, double highest, double reach, Brands& brands,
               Random& random) {
  const double half = std::min(size.x() / 2, reach), front = -size.y() / 2 + random.uniform(0, 0.06);
  int standing = line_up(tabletop, -half, half, front, size.y() - 0.07, highest, brands, random);
  repeat_as_fits(random.integer(0, 4), 0,
                 [&] { return stack(tabletop, random_grocery(brands.next(), random), random); });
  return standing >= 3;
}

void lower(Room& room, double by) {
  room.table.pose.pretranslate(Eigen::Vector3d(0, 0, -by));
  for (Body& body : room.furniture) body.pose.pretranslate(Eigen::Vector3d(0, 0, -by));
}

Arrangement arranged(const Viewpoint& viewpoint, const Room& room, const Tabletop& tabletop, Random& random) {
  return {viewpoint, random_lighting(random), room.table, {}, room.furniture, tabletop.bodies()};
}

std::optional<Arrangement> lay_out_shelf(const Viewpoint& viewpoint, double smallest, Random& random) {
  const Eigen::Vector2d size{random.uniform(0.5, 1.2), random.uniform(0.2, 0.42)};
  const double above = random.uniform(0.26, 0.5);
  // A board above the camera's eye is all that would be seen.
  const bool has_above = random.chance(0.7) && viewpoint.pose.translation().z() < above - 0.03;
  Room room = room_around_board(size, random);
  Tabletop tabletop(viewpoint, room.top, 0, smallest, size.norm() / 2);
  for (Body& board : shelf(size, has_above ? above : 0, random)) {
    tabletop.furnish(board);
    room.furniture.push_back(std::move(board));
  }
  Brands brands(random);
  if (!lay_shelf(tabletop, size, has_above ? above - 0.02 : 0.4, reach_of(viewpoint), brands, random))
    return std::nullopt;
  Arrangement arrangement = arranged(viewpoint, room, tabletop, random);
  arrangement.lighting.lamp.y() = -random.uniform(0.8, 2);  // before the shelf: boards above would darken it
  return arrangement;
}

std::optional<Arrangement> lay_out_bin(const Viewpoint& viewpoint, double smallest, Random& random) {
  Room room = random_room(random);
  lower(room, container_floor);
  const double width = std::clamp(1.9 * reach_of(viewpoint), 0.25, 0.55) * random.uniform(0.8, 1.1);
  const Eigen::Vector3d inner{width, width * random.uniform(0.6, 0.9), random.uniform(0.07, 0.3)};
  const double yaw = degree * random.uniform(-180, 180);
  const Eigen::Isometry3d pose(Eigen::Translation3d(0, 0, 0) * about_z(yaw));
  const Eigen::Vector2d half = inner.head<2>() / 2;
  Tabletop tabletop(viewpoint, {Eigen::Vector2d(-half), half}, yaw, smallest, 0.85 * half.maxCoeff());
  for (Body& wall : bin(inner, pose, random)) {
    tabletop.furnish(wall);
    room.furniture.push_back(std::move(wall));
  }
  Brands brands(random);
  if (!lay_bin(tabletop, inner, pose, brands, random)) return std::nullopt;
  return arranged(viewpoint, room, tabletop, random);
}

}  // namespace

std::optional<Arrangement> lay_out_in_room(Category category, const Camera& camera, Random& random) {
  const Viewpoint viewpoint = look(camera, framing_of(category), random);
  // As on the bare table.
  const double smallest = 1.6 * smallest_object(camera);
  if (category == Category::bin) return lay_out_bin(viewpoint, smallest, random);
  if (category == Category::shelf) return lay_out_shelf(viewpoint, smallest, random);
  const Room room = random_room(random);
  const double reach = reach_of(viewpoint);
  Tabletop tabletop(viewpoint, room.top, room.yaw, smallest, std::min(reach, random.uniform(0.15, 0.4)),
                    random.chance(0.3) ? 0.5 : 0.98);
  Brands brands(random);
  const bool laid = category == Category::packages    ? lay_packages(tabletop, reach, brands, random)
                    : category == Category::groceries ? lay_groceries(tabletop, reach, brands, random)
                                                      : lay_small_things(tabletop, brands, random);
  if (!laid) return std::nullopt;
  return arranged(viewpoint, room, tabletop, random);
}

}  // namespace gestalt::synthesis
