// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "layout.h"

#include <algorithm>
#include <cmath>

#include "brands.h"
#include "degree.h"
#include "repeat.h"
#include "room_layout.h"
#include "shapes.h"
#include "tabletop.h"

namespace gestalt::synthesis {

namespace {

/// How far and how steeply a category is looked at, and how much of the table it takes.
struct Framing {
  double nearest, farthest;   // metres to the things
  double flattest, steepest;  // degrees below the horizon
  double working_radius;      // metres
};

Framing framing_of(Category category) {
  switch (category) {
    case Category::boxes:
    case Category::stacked_boxes:
      return {0.75, 1.1, 30, 55, 0.2};
    case Category::occluded_objects:
      return {0.75, 1.05, 28, 40, 0.2};
    case Category::cylindric_objects:
      return {0.7, 1.05, 32, 58, 0.2};
    case Category::mixed_objects:
      return {0.8, 1.1, 32, 58, 0.24};
    default:
      break;  // complex_scene
  }
  return {0.85, 1.1, 38, 60, 0.26};
}

Viewpoint look_at_table(const Camera& camera, const Framing& framing, Random& random) {
  const double distance = random.uniform(framing.nearest, framing.farthest);
  const double pitch = degree * random.uniform(framing.flattest, framing.steepest);
  const Eigen::Vector3d target{random.uniform(-0.05, 0.05), random.uniform(-0.05, 0.05), 0.05};
  const Eigen::Vector3d forward(0, std::cos(pitch), -std::sin(pitch));
  const Eigen::Vector3d right = Eigen::Vector3d::UnitX(), down = forward.cross(right);
  Viewpoint viewpoint{camera, Eigen::Isometry3d::Identity()};
  viewpoint.pose.linear() << right, down, forward;
  viewpoint.pose.linear() *= Eigen::AngleAxisd(degree * random.uniform(-3, 3), Eigen::Vector3d::UnitZ()).matrix();
  viewpoint.pose.translation() = target - distance * forward;
  return viewpoint;
}

struct Furniture {
  Body table;
  Eigen::AlignedBox2d top;  // in the table's own frame
  double yaw;
};

Furniture furnish(Random& random) {
  Furniture furniture;
  furniture.yaw = degree * random.uniform(-12, 12);
  const auto half_width = [&] { return random.uniform(0.42, 0.9); };
  furniture.top = {Eigen::Vector2d{-half_width(), -random.uniform(0.45, 1.0)},
                   Eigen::Vector2d{half_width(), random.uniform(0.45, 0.9)}};
  const Eigen::Vector2d size = furniture.top.sizes();
  constexpr double thickness = 0.03;
  Body& table = furniture.table;
  table.mesh = box({size.x(), size.y(), thickness});
  table.size << size.x(), size.y(), thickness;
  const Texture top = wood(size.x(), size.y(), random);
  table.paint.parts = {top};
  const Eigen::Vector2d centre = Eigen::Rotation2Dd(furniture.yaw) * furniture.top.center();
  table.pose = Eigen::Translation3d(centre.x(), centre.y(), -thickness) *
               Eigen::AngleAxisd(furniture.yaw, Eigen::Vector3d::UnitZ());
  return furniture;
}

std::vector<Body> surround(Random& random) {
  const double floor = -random.uniform(0.65, 0.8), wall = random.uniform(1.6, 3);
  Body ground, back;
  add_sheet(
      ground.mesh,
      [=](double u, double v) -> Eigen::Vector3d {
        return {8 * u - 4, 8 * v - 4, floor};
      },
      1, 1, {8, 8}, 0);
  ground.paint.parts = {wood(1.2, 1.2, random)};
  add_sheet(
      back.mesh,
      [=](double u, double v) -> Eigen::Vector3d {
        return {8 * u - 4, wall, 3 - 4 * v};
      },
      1, 1, {8, 4}, 0);
  back.paint.parts = {room(8, 4, random)};
  return {ground, back};
}

Kind any_kind(Random& random) {
  static const Kind kinds[] = {Kind::carton, Kind::carton, Kind::carton, Kind::carton, Kind::can,
                               Kind::can,    Kind::bowl,   Kind::mug,    Kind::bottle, Kind::cone,
                               Kind::pebble, Kind::pebble, Kind::prism};
  return random.pick(kinds);
}

/// On something that carries it: upright, not too high and about as wide.
bool stand_on_any(Tabletop& tabletop, const Body& body, double offset, Random& random) {
  std::vector<int> supports;
  for (int i = 0; i < int(tabletop.bodies().size()); ++i) {
    const Body& support = tabletop.bodies()[std::size_t(i)];
    if (support.pose.linear()(2, 2) > 0.99 && support.size.z() < 0.14 &&
        support.size.head<2>().minCoeff() > 0.7 * body.size.head<2>().minCoeff())
      supports.push_back(i);
  }
  return !supports.empty() && tabletop.stand_on(body, random.pick(supports), offset, random);
}

bool lay_boxes(Tabletop& tabletop, Brands& brands, Random& random) {
  return repeat(random.integer(1, 4),
                [&] { return tabletop.stand_free(random_body(Kind::carton, brands.next(), random), random, false); });
}

bool lay_stacked_boxes(Tabletop& tabletop, Brands& brands, Random& random) {
  const int levels = random.integer(2, 4);
  Eigen::Vector3d size{random.uniform(0.14, 0.28), random.uniform(0.1, 0.2),
                       random.uniform(0.03, levels < 4 ? 0.12 : 0.07)};
  if (!tabletop.stand_free(carton(size, brands.next(), random), random, false)) return false;
  for (int level = 1; level < levels; ++level) {
    const bool same = random.chance(0.3);  // two of a kind
    if (!same)
      size = {size.x() * random.uniform(0.55, 1.15), size.y() * random.uniform(0.55, 1.15), random.uniform(0.03, 0.1)};
    const double offset = random.chance(0.3) ? 0 : random.uniform(0.2, 0.7);
    if (!tabletop.stand_on(carton(size, brands.next(), random), level - 1, offset, random)) return false;
  }
  return repeat(levels < 4 ? random.integer(0, 2) : 0, [&] {
    const Body box = random_body(Kind::carton, brands.next(), random);
    return random.chance(0.5) ? tabletop.stand_beside(box, random) : tabletop.stand_free(box, random, false);
  });
}

bool lay_occluded_objects(Tabletop& tabletop, Brands& brands, Random& random) {
  // The rear thing lies across the view; the front one, narrower and higher, stands before its middle.
  const double across = degree * random.uniform(-18, 18);
  const Eigen::Matrix3d turned = Eigen::AngleAxisd(across, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector2d rear{random.uniform(-0.08, 0.08), random.uniform(0.02, 0.12)};
  const Eigen::Vector3d bar{random.uniform(0.2, 0.3), random.uniform(0.03, 0.08), random.uniform(0.035, 0.1)};
  if (random.chance(0.3)) {  // a tube on its side
    Body tube{cylinder(bar.z() / 2, bar.x()),
              {{print(3 * bar.z(), bar.x(), brands.next(), random)}},
              {bar.z(), bar.z(), bar.x()}};
    const Eigen::Matrix3d lying = turned * Eigen::AngleAxisd(90 * degree, Eigen::Vector3d::UnitY()).toRotationMatrix();
    if (!tabletop.stand_at(tube, lying, rear - (turned * Eigen::Vector3d(bar.x() / 2, 0, 0)).head<2>())) return false;
  } else if (!tabletop.stand_at(carton(bar, brands.next(), random), turned, rear)) {
    return false;
  }
  static const Kind high[] = {Kind::can, Kind::bottle, Kind::carton, Kind::carton, Kind::cone};
  const Kind kind = random.pick(high);
  const Palette& palette = brands.next();
  const Body front =
      kind == Kind::carton
          ? carton({random.uniform(0.05, 0.1), random.uniform(0.03, 0.08), random.uniform(0.16, 0.28)}, palette, random)
          : random_body(kind, palette, random);
  const Eigen::Matrix3d yaw =
      Eigen::AngleAxisd(degree * random.uniform(-40, 40), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  const Eigen::Vector2d before{random.uniform(-0.03, 0.03), -bar.y() / 2 - random.uniform(0.06, 0.14)};
  if (!tabletop.stand_at(front, yaw, rear + before)) return false;
  const auto rear_is_cut = [&] {
    const std::vector<double> parts = tabletop.preview().visible_parts(0);
    return parts.size() >= 2 && parts[1] >= 0.1 * parts[0];
  };
  if (!rear_is_cut()) return false;
  return repeat(random.integer(0, 2),
                [&] {
                  const Palette& other = brands.next();
                  return tabletop.stand_free(random_body(any_kind(random), other, random), random, false);
                }) &&
         rear_is_cut();
}

bool lay_cylindric_objects(Tabletop& tabletop, Brands& brands, Random& random) {
  static const Kind kinds[] = {Kind::can, Kind::can, Kind::mug, Kind::bowl, Kind::bowl, Kind::bottle};
  return repeat(random.integer(2, 6), [&] {
    const Kind kind = random.pick(kinds);
    const Body body = random_body(kind, brands.next(), random);
    return random.chance(0.15) ? tabletop.stand_beside(body, random)
                               : tabletop.stand_free(body, random, kind == Kind::can);
  });
}

bool lay_mixed_objects(Tabletop& tabletop, Brands& brands, Random& random) {
  return repeat(random.integer(5, 9), [&] {
    const Kind kind = any_kind(random);
    const Body body = random_body(kind, brands.next(), random);
    const int present = int(tabletop.bodies().size());
    const double way = present == 0 ? 1 : random.uniform();
    if (way < 0.22) return stand_on_any(tabletop, body, 0.5, random);
    if (way < 0.5) return tabletop.stand_beside(body, random);
    if (way < 0.56) return tabletop.tumble(body, random);
    return tabletop.stand_free(body, random, kind == Kind::can || kind == Kind::bottle);
  });
}

bool lay_complex_scene(Tabletop& tabletop, Brands& brands, Random& random) {
  return repeat(random.integer(15, 20), [&] {
    const Kind kind = any_kind(random);
    const Body body = random_body(kind, brands.next(), random);
    const int present = int(tabletop.bodies().size());
    const double way = present < 3 ? 1 : random.uniform();
    if (way < 0.15) return stand_on_any(tabletop, body, 0.6, random);
    if (way < 0.35) return tabletop.stand_beside(body, random);
    if (way < 0.75) return tabletop.tumble(body, random);
    return tabletop.stand_free(body, random, true);
  });
}

bool lay(Category category, Tabletop& tabletop, Random& random) {
  Brands brands(random);
  switch (category) {
    case Category::boxes:
      return lay_boxes(tabletop, brands, random);
    case Category::stacked_boxes:
      return lay_stacked_boxes(tabletop, brands, random);
    case Category::occluded_objects:
      return lay_occluded_objects(tabletop, brands, random);
    case Category::cylindric_objects:
      return lay_cylindric_objects(tabletop, brands, random);
    case Category::mixed_objects:
      return lay_mixed_objects(tabletop, brands, random);
    default:
      break;  // complex_scene
  }
  return lay_complex_scene(tabletop, brands, random);
}

}  // namespace

std::optional<Arrangement> lay_out(Category category, const Camera& camera, Random& random) {
  if (category > Category::complex_scene) return lay_out_in_room(category, camera, random);
  const Framing framing = framing_of(category);
  const Viewpoint viewpoint = look_at_table(camera, framing, random);
  const Furniture furniture = furnish(random);
  // Points along edges and those that the sensor drops are counted by the preview too: leave some to spare.
  const double smallest = 1.6 * smallest_object(camera);
  Tabletop tabletop(viewpoint, furniture.top, furniture.yaw, smallest, framing.working_radius);
  if (!lay(category, tabletop, random)) return std::nullopt;
  return Arrangement{viewpoint, random_lighting(random), furniture.table, surround(random), {}, tabletop.bodies()};
}

}  // namespace gestalt::synthesis
