// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <span>

namespace gestalt {

/// Sums over points from which their mean and their least-squares plane follow; those of two sets of points add up.
/// Where the spread is small beside the distance from the origin, the points are to be given relative to one of them,
/// as squares cancel.
struct Moments {
  double weight = 0;  ///< number of points, where each counts as one
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

  Moments() = default;

  /// Of points that count as one each.
  explicit Moments(std::span<const Eigen::Vector3f> points) : weight(double(points.size())) {
    double x = 0, y = 0, z = 0, xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;  // stay in registers
    for (const Eigen::Vector3f& p : points) {
      const double px = p.x(), py = p.y(), pz = p.z();
      x += px, y += py, z += pz;
      xx += px * px, xy += px * py, xz += px * pz;
      yy += py * py, yz += py * pz, zz += pz * pz;
    }
    sum << x, y, z;
    squares << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  }

  void add(const Eigen::Vector3d& p, double w = 1) {
    weight += w;
    sum += w * p;
    squares.noalias() += w * p * p.transpose();
  }

  Moments& operator+=(const Moments& other) {
    weight += other.weight;
    sum += other.sum;
    squares += other.squares;
    return *this;
  }
  friend Moments operator+(Moments a, const Moments& b) { return a += b; }

  // These are of points that have a weight.
  Eigen::Vector3d mean() const { return sum / weight; }
  Eigen::Matrix3d covariance() const { return squares / weight - mean() * mean().transpose(); }

  /// Unit normal of the least-squares plane, which goes through mean(): towards the origin, where the camera is.
  Eigen::Vector3d normal() const {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(covariance());
    const Eigen::Vector3d normal = axes.eigenvectors().col(0);
    return normal.dot(mean()) > 0 ? Eigen::Vector3d(-normal) : normal;
  }
};

}  // namespace gestalt
