// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "height_field.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace gestalt::synthesis {

namespace {

constexpr float cell = 0.004f;  // metres
constexpr float reach = 0.9f;   // metres from the origin
constexpr int cells = int(2 * reach / cell);

/// Row-major index, or -1 outside of the field.
int index_of(float x, float y) {
  const float column = (x + reach) / cell, row = (y + reach) / cell;
  return column >= 0 && row >= 0 && column < cells && row < cells ? int(row) * cells + int(column) : -1;
}

}  // namespace

HeightField::HeightField() : heights_(std::size_t(cells) * cells, 0.f) {}

double HeightField::at(float x, float y) const {
  const int index = index_of(x, y);
  return index < 0 ? 0.0 : double(heights_[std::size_t(index)]);
}

void HeightField::add(std::span<const Eigen::Vector3f> points) {
  for (const Eigen::Vector3f& point : points)
    if (const int index = index_of(point.x(), point.y()); index >= 0)
      heights_[std::size_t(index)] = std::max(heights_[std::size_t(index)], point.z());
}

double HeightField::resting_height(std::span<const Eigen::Vector3f> points, const Eigen::Matrix3d& orientation,
                                   double x, double y) const {
  const Eigen::Matrix3f rotation = orientation.cast<float>();
  const Eigen::Vector3f shift(float(x), float(y), 0);
  float height = -1;
  for (const Eigen::Vector3f& point : points) {
    const Eigen::Vector3f turned = rotation * point + shift;
    const int index = index_of(turned.x(), turned.y());
    height = std::max(height, (index < 0 ? 0.f : heights_[std::size_t(index)]) - turned.z());
  }
  return double(height);
}

Eigen::Isometry3d settle(const HeightField& field, std::span<const Eigen::Vector3f> points,
                         const Eigen::Vector3d& centre_of_mass, const Eigen::Matrix3d& orientation, double x, double y,
                         double swing) {
  const auto pose_of = [&](const Eigen::Matrix3d& rotation) {
    // The centre of mass stays above (x, y), so that tilting cannot carry the thing away.
    const Eigen::Vector3d offset = rotation * centre_of_mass;
    Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
    pose.linear() = rotation;
    const double px = x - offset.x(), py = y - offset.y();
    pose.translation() << px, py, field.resting_height(points, rotation, px, py);
    return pose;
  };
  Eigen::Isometry3d best = pose_of(orientation);
  const auto potential = [&](const Eigen::Isometry3d& pose) { return (pose * centre_of_mass).z(); };
  // A thing on an edge gets lower only by turning about that edge, so axes of every heading are tried, the last first.
  constexpr int headings = 12;
  int heading = 0;
  for (const double degrees : {swing, 4.0, 1.0})
    for (int steps = 0, failures = 0; steps < 30 && failures < headings;) {
      const double angle = 2 * std::numbers::pi * heading / headings;
      const Eigen::Vector3d axis(std::cos(angle), std::sin(angle), 0);
      const Eigen::AngleAxisd tilt(degrees * std::numbers::pi / 180, axis);
      const Eigen::Isometry3d tilted = pose_of(tilt.toRotationMatrix() * best.linear());
      if (potential(tilted) < potential(best) - 1e-4) {
        best = tilted;
        ++steps;
        failures = 0;
      } else {
        heading = (heading + 5) % headings;  // 5 has no divisor in common with 12: all headings, far ones first
        ++failures;
      }
    }
  return best;
}

}  // namespace gestalt::synthesis
