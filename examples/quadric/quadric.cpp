// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "quadric.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace {

using Vector6d = Eigen::Matrix<double, 6, 1>;

/// 1, a, b, a^2, ab, b^2.
Vector6d terms(double a, double b) {
  Vector6d all;
  all << 1, a, b, a * a, a * b, b * b;
  return all;
}

/// The plane that the height stands on: where the points are, how far they reach, and a column for each axis, the
/// height last. Positions in it are divided by the reach, so that the equations are well conditioned at any size.
struct Ground {
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  Eigen::Vector3d variances;  ///< ascending
  Eigen::Matrix3d axes;
  double reach = 0;

  explicit Ground(std::span<const Eigen::Vector3f> points) {
    for (const Eigen::Vector3f& p : points) mean += p.cast<double>() / double(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector3d d = p.cast<double>() - mean;
      covariance += d * d.transpose() / double(points.size());
      reach = std::max(reach, d.norm());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
    variances = eigen.eigenvalues();
    axes << eigen.eigenvectors().col(2), eigen.eigenvectors().col(1), eigen.eigenvectors().col(0);
  }

  Eigen::Vector3d into(const Eigen::Vector3f& p) const { return axes.transpose() * (p.cast<double>() - mean) / reach; }
  Eigen::Vector3d out_of(const Eigen::Vector3d& q) const { return mean + axes * q * reach; }
};

class QuadricModel final : public gestalt::SurfaceModel {
 public:
  QuadricModel(const Ground& ground, const Vector6d& height) : ground_(ground), height_(height) {}

  std::string type() const override { return "quadric"; }

  Foot foot(const Eigen::Vector3f& p) const override {
    const Eigen::Vector3d q = ground_.into(p);
    double a = q.x(), b = q.y();
    for (int step = 0; step < 10; ++step) {
      // Gauss-Newton for the nearest (a, b, h(a, b)); beyond the points the parabola tells nothing, so it stays near.
      const auto [h, slope] = height_at(a, b);
      Eigen::Matrix<double, 3, 2> jacobian;
      jacobian << 1, 0, 0, 1, slope.x(), slope.y();
      const Eigen::Vector3d error = q - Eigen::Vector3d(a, b, h);
      const Eigen::Vector2d change =
          (jacobian.transpose() * jacobian).ldlt().solve(Eigen::Vector2d(jacobian.transpose() * error));
      a = std::clamp(a + change.x(), -1.5, 1.5);
      b = std::clamp(b + change.y(), -1.5, 1.5);
      if (change.squaredNorm() < 1e-14) break;
    }
    const auto [h, slope] = height_at(a, b);
    const Eigen::Vector3d point = ground_.out_of({a, b, h});
    Eigen::Vector3d normal = (ground_.axes * Eigen::Vector3d(-slope.x(), -slope.y(), 1)).normalized();
    if (normal.dot(point) > 0) normal = -normal;  // towards the camera
    return {point.cast<float>(), normal.cast<float>()};
  }

  nlohmann::json to_json() const override {
    const auto list = [](const auto& v) { return std::vector<double>(v.begin(), v.end()); };
    return {{"type", type()},
            {"centre", list(ground_.mean)},
            {"axes", {list(ground_.axes.col(0)), list(ground_.axes.col(1)), list(ground_.axes.col(2))}},
            {"reach", ground_.reach},
            {"height", list(height_)}};
  }

 private:
  struct Height {
    double h;
    Eigen::Vector2d slope;
  };
  Height height_at(double a, double b) const {
    return {height_.dot(terms(a, b)),
            {height_[1] + 2 * height_[3] * a + height_[4] * b, height_[2] + height_[4] * a + 2 * height_[5] * b}};
  }

  Ground ground_;
  Vector6d height_;
};

std::string why_not(std::span<const Eigen::Vector3f> points, const Ground& ground) {
  if (points.size() < 12) return "fewer than 12 points";
  return ground.variances[1] < 1e-10 ? "collinear points" : "";
}

}  // namespace

const gestalt::Parameters<Quadric::Params>& Quadric::parameters() {
  static const auto parameters = gestalt::Parameters<Params>().real("parameter_count", &Params::parameter_count, 1,
                                                                    1000, "", "cost in model selection, S_m of Eq. 3");
  return parameters;
}

std::shared_ptr<const gestalt::SurfaceModel> Quadric::fit(std::span<const Eigen::Vector3f> points) const {
  const Ground ground(points);
  if (!why_not(points, ground).empty()) return nullptr;
  Eigen::Matrix<double, 6, 6> normal_matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Vector6d right = Vector6d::Zero();
  for (const Eigen::Vector3f& p : points) {
    const Eigen::Vector3d q = ground.into(p);
    const Vector6d t = terms(q.x(), q.y());
    normal_matrix.selfadjointView<Eigen::Lower>().rankUpdate(t);
    right += q.z() * t;
  }
  // A narrow strip leaves the bend across it open: then it is none.
  normal_matrix.diagonal() += Vector6d::Constant(1e-9 * double(points.size()));
  return std::make_shared<QuadricModel>(ground, normal_matrix.selfadjointView<Eigen::Lower>().ldlt().solve(right));
}

std::string Quadric::refusal(std::span<const Eigen::Vector3f> points) const { return why_not(points, Ground(points)); }
