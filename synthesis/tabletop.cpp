// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tabletop.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "shapes.h"

namespace gestalt::synthesis {

namespace {

constexpr int tries = 12;
constexpr double touching = 0.001;  // metres: a thing this high above the table rests on something else
constexpr double highest = 0.24;    // metres that a pile may reach

Eigen::Matrix3d about_z(double angle) { return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ()).toRotationMatrix(); }

Eigen::Matrix3d onto_its_side(double angle) {
  return about_z(angle) * Eigen::AngleAxisd(turn / 4, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

/// Uniform over all orientations (Shoemake: Uniform random rotations, 1992).
Eigen::Matrix3d random_orientation(Random& random) {
  const double u = random.uniform(), a = random.uniform(0, turn), b = random.uniform(0, turn);
  const double p = std::sqrt(1 - u), q = std::sqrt(u);
  return Eigen::Quaterniond(q * std::cos(b), p * std::sin(a), p * std::cos(a), q * std::sin(b)).toRotationMatrix();
}

/// The first point in each cube with this edge (metres).
std::vector<Eigen::Vector3f> thinned(const std::vector<Eigen::Vector3f>& points, float edge) {
  Eigen::AlignedBox3f bounds;
  for (const Eigen::Vector3f& point : points) bounds.extend(point);
  const Eigen::Array3i cubes = (bounds.sizes().array() / edge).floor().cast<int>() + 1;
  std::vector<bool> taken(std::size_t(cubes.prod()), false);
  std::vector<Eigen::Vector3f> kept;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Array3i cube = ((point - bounds.min()).array() / edge).floor().cast<int>();
    const auto index = std::size_t((cube.z() * cubes.y() + cube.y()) * cubes.x() + cube.x());
    if (taken[index]) continue;
    taken[index] = true;
    kept.push_back(point);
  }
  return kept;
}

}  // namespace

Tabletop::Tabletop(const Viewpoint& viewpoint, const Eigen::AlignedBox2d& table, double table_yaw, double smallest,
                   double working_radius, double least_inside)
    : table_(table),
      to_table_(-table_yaw),
      smallest_(smallest),
      working_radius_(working_radius),
      least_inside_(least_inside),
      preview_(viewpoint) {}

Tabletop::Points Tabletop::points_of(const Body& body) {
  Points points{{}, sample_surface(body.mesh, 0.0025), {}};
  points.coarse = thinned(points.fine, 0.007f);
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3f& point : points.coarse) sum += point.cast<double>();
  points.centre_of_mass = sum / double(points.coarse.size());
  return points;
}

bool Tabletop::drop(const Body& body, const Points& points, const Eigen::Matrix3d& orientation,
                    const Eigen::Vector2d& at, double swing) {
  Eigen::Isometry3d pose = settle(field_, points.coarse, points.centre_of_mass, orientation, at.x(), at.y(), swing);
  Eigen::Vector3d place_of = pose.translation();
  place_of.z() = field_.resting_height(points.fine, pose.linear(), place_of.x(), place_of.y());
  pose.translation() = place_of;
  const bool low = std::all_of(points.coarse.begin(), points.coarse.end(),
                               [&](const auto& point) { return (pose * point.template cast<double>()).z() < highest; });
  return low && place(body, points, pose);
}

bool Tabletop::place(const Body& body, const Points& points, const Eigen::Isometry3d& pose) {
  std::vector<Eigen::Vector3f> world(points.fine.size());
  const Eigen::Isometry3f to_world = pose.cast<float>();
  std::transform(points.fine.begin(), points.fine.end(), world.begin(), [&](const auto& p) { return to_world * p; });
  const bool on_table = std::all_of(world.begin(), world.end(), [&](const Eigen::Vector3f& p) {
    return table_.contains(to_table_ * p.head<2>().cast<double>());
  });
  if (!on_table || preview_.share_inside(world) < least_inside_ || !preview_.add(world, smallest_)) return false;
  field_.add(world);
  bodies_.push_back(body);
  bodies_.back().pose = pose;
  return true;
}

bool Tabletop::put(const Body& body) { return place(body, points_of(body), body.pose); }

void Tabletop::furnish(const Body& body) {
  std::vector<Eigen::Vector3f> world = sample_surface(body.mesh, 0.0025);
  for (Eigen::Vector3f& point : world) point = body.pose.cast<float>() * point;
  field_.add(world);
  preview_.hide_behind(world);
}

Eigen::Vector2d Tabletop::random_spot(Random& random) const {
  const double angle = random.uniform(0, turn), radius = working_radius_ * std::sqrt(random.uniform());
  return {1.15 * radius * std::cos(angle), 0.9 * radius * std::sin(angle)};
}

bool Tabletop::stand_at(const Body& body, const Eigen::Matrix3d& orientation, const Eigen::Vector2d& at) {
  const Points points = points_of(body);
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = orientation;
  pose.translation() << at.x(), at.y(), field_.resting_height(points.fine, orientation, at.x(), at.y());
  const Eigen::RowVector3f up = orientation.row(2).cast<float>();
  float lowest = std::numeric_limits<float>::infinity();
  for (const Eigen::Vector3f& point : points.fine) lowest = std::min(lowest, up.dot(point.transpose()));
  if (pose.translation().z() + double(lowest) > touching) return false;
  return place(body, points, pose);
}

bool Tabletop::stand_free(const Body& body, Random& random, bool may_lie) {
  const bool lies = may_lie && random.chance(0.2);
  for (int i = 0; i < tries; ++i) {
    const double yaw = random.uniform(0, turn);
    if (stand_at(body, lies ? onto_its_side(yaw) : about_z(yaw), random_spot(random))) return true;
  }
  return false;
}

bool Tabletop::stand_beside(const Body& body, Random& random) {
  if (bodies_.empty()) return stand_free(body, random, false);
  const Points points = points_of(body);
  for (int i = 0; i < tries; ++i) {
    const Body& neighbour = random.pick(bodies_);
    const Eigen::Vector2d centre = neighbour.pose.translation().head<2>();
    const double yaw_there = std::atan2(neighbour.pose.linear()(1, 0), neighbour.pose.linear()(0, 0));
    const bool aligned = random.chance(0.6);  // as cartons on a shelf
    const double yaw = aligned ? yaw_there + turn / 4 * random.integer(0, 3) : random.uniform(0, turn);
    const double heading = aligned ? yaw_there + turn / 4 * random.integer(0, 3) : random.uniform(0, turn);
    const Eigen::Vector2d direction(std::cos(heading), std::sin(heading));
    const Eigen::Matrix3d orientation = about_z(yaw);
    const auto free_at = [&](double distance) {
      const Eigen::Vector2d at = centre + distance * direction;
      return field_.resting_height(points.fine, orientation, at.x(), at.y()) < touching;
    };
    double apart = 0.4, overlapping = 0;
    if (!free_at(apart) || free_at(overlapping)) continue;
    while (apart - overlapping > 0.002) {
      const double middle = (apart + overlapping) / 2;
      (free_at(middle) ? apart : overlapping) = middle;
    }
    if (stand_at(body, orientation, centre + apart * direction)) return true;
  }
  return false;
}

bool Tabletop::stand_on(const Body& body, int support, double offset, Random& random) {
  const Points points = points_of(body);
  const Body below = bodies_[std::size_t(support)];
  for (int i = 0; i < tries; ++i) {
    const Eigen::Vector3d within{offset * random.uniform(-0.5, 0.5) * below.size.x(),
                                 offset * random.uniform(-0.5, 0.5) * below.size.y(), 0};
    const Eigen::Vector3d at = below.pose * within;
    const double yaw_there = std::atan2(below.pose.linear()(1, 0), below.pose.linear()(0, 0));
    const double yaw = random.chance(0.5) ? yaw_there + turn / 4 * random.integer(0, 3) : random.uniform(0, turn);
    if (drop(body, points, about_z(yaw), at.head<2>(), 4)) return true;
  }
  return false;
}

bool Tabletop::tumble(const Body& body, Random& random) {
  const Points points = points_of(body);
  for (int i = 0; i < tries; ++i) {
    const Eigen::Vector2d at = random_spot(random);
    const Eigen::Matrix3d orientation = random_orientation(random);
    if (drop(body, points, orientation, at, 15)) return true;
  }
  return false;
}

}  // namespace gestalt::synthesis
