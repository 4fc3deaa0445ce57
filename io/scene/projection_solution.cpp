// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "projection_solution.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

using Projection = Eigen::Matrix<double, 3, 4>;

/// Moves and scales coordinates to mean 0 and mean square 1, without which the equations are badly conditioned.
template <int Dimension>
Eigen::Matrix<double, Dimension + 1, Dimension + 1> normalising(
    const Eigen::Matrix<double, Dimension, Eigen::Dynamic>& x) {
  const Eigen::Matrix<double, Dimension, 1> mean = x.rowwise().mean();
  const double spread = std::sqrt((x.colwise() - mean).squaredNorm() / double(x.cols()));
  const double scale = spread > 0 ? 1 / spread : 1;
  Eigen::Matrix<double, Dimension + 1, Dimension + 1> result;
  result.setIdentity();
  result.template topLeftCorner<Dimension, Dimension>() *= scale;
  result.template topRightCorner<Dimension, 1>() = -scale * mean;
  return result;
}

/// M = K R with K upper triangular of positive diagonal and R orthogonal.
std::pair<Eigen::Matrix3d, Eigen::Matrix3d> rq(const Eigen::Matrix3d& m) {
  const Eigen::Matrix3d swap = Eigen::Matrix3d::Identity().rowwise().reverse();
  const Eigen::HouseholderQR<Eigen::Matrix3d> qr((swap * m).transpose());
  const Eigen::Matrix3d upper = qr.matrixQR().triangularView<Eigen::Upper>();
  Eigen::Matrix3d k = swap * upper.transpose() * swap;
  Eigen::Matrix3d r = swap * Eigen::Matrix3d(qr.householderQ()).transpose();
  for (int i = 0; i < 3; ++i)
    if (k(i, i) < 0) k.col(i) *= -1, r.row(i) *= -1;
  return {k, r};
}

}  // namespace

std::optional<CameraPose> solve_projection(const std::vector<StoredPoint>& points) {
  constexpr std::size_t fewest = 100;
  // A second solution, or nearly one, means that the points do not tell: they lie in a plane.
  constexpr double least_gap = 100, least_second = 1e-9;
  constexpr double largest_skew = 0.01, largest_stretch = 1.2;
  if (points.size() < fewest) return std::nullopt;
  Eigen::Matrix<double, 3, Eigen::Dynamic> x(3, Eigen::Index(points.size()));
  Eigen::Matrix<double, 2, Eigen::Dynamic> u(2, Eigen::Index(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    const cv::Vec3f& p = points[i].point;
    x.col(Eigen::Index(i)) << p[0], p[1], p[2];
    u.col(Eigen::Index(i)) << points[i].pixel.x, points[i].pixel.y;
  }
  const Eigen::Matrix4d move_points = normalising<3>(x);
  const Eigen::Matrix3d move_pixels = normalising<2>(u);
  Eigen::Matrix<double, 12, 12> squares = Eigen::Matrix<double, 12, 12>::Zero();
  for (Eigen::Index i = 0; i < x.cols(); ++i) {
    const Eigen::Vector4d p = move_points * x.col(i).homogeneous();
    const Eigen::Vector3d q = move_pixels * u.col(i).homogeneous();
    Eigen::Matrix<double, 2, 12> rows;
    rows << p.transpose(), Eigen::RowVector4d::Zero(), -q[0] * p.transpose(),  //
        Eigen::RowVector4d::Zero(), p.transpose(), -q[1] * p.transpose();
    squares += rows.transpose() * rows;
  }
  if (!squares.allFinite()) return std::nullopt;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, 12, 12>> solver(squares);
  const auto& values = solver.eigenvalues();
  if (!(values[1] > least_second * values[11]) || !(values[1] > least_gap * std::abs(values[0]))) return std::nullopt;
  const Eigen::Matrix<double, 3, 4, Eigen::RowMajor> normal =
      Eigen::Map<const Eigen::Matrix<double, 3, 4, Eigen::RowMajor>>(solver.eigenvectors().col(0).data());
  Projection projection = move_pixels.inverse() * normal * move_points;
  // Either sign solves the equations; the points lie before the camera.
  if (Eigen::VectorXd depths = (projection.row(2) * x.colwise().homogeneous()).transpose();
      (depths.array() < 0).count() > depths.size() / 2)
    projection = -projection;
  const auto [k, rotation] = rq(projection.leftCols<3>());
  const double fx = k(0, 0), fy = k(1, 1);
  if (!(fx > 0) || !(fy > 0) || !(std::max(fx, fy) < largest_stretch * std::min(fx, fy)) ||
      !(std::abs(k(0, 1)) < largest_skew * fx))
    return std::nullopt;
  const Eigen::Vector3d translation = k.inverse() * projection.col(3);
  CameraPose pose;
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) pose.rotation(row, column) = rotation(row, column);
    pose.translation[row] = translation[row];
  }
  return pose;
}

}  // namespace gestalt
