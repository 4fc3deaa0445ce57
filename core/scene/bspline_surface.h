// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// The B-spline basis functions that are not zero at a place, with their derivatives (Cox, de Boor).
struct BsplineBasis {
  static constexpr int largest_degree = 5;
  using Values = std::array<double, largest_degree + 1>;

  int first = 0;  ///< index of the first of the degree + 1 functions
  Values value{};
  Values first_derivative{};
  Values second_derivative{};
};

/// At x, which is clamped to the domain [knots[degree], knots[n]] of n = knots.size() - degree - 1 functions. Knots
/// ascend, and the domain is not empty.
GESTALT_EXPORT BsplineBasis bspline_basis(int degree, const std::vector<double>& knots, double x);

/// Knots for that many control points over [0, 1], uniform inside, with which the surface ends in its outer control
/// points. control_points > degree >= 1.
GESTALT_EXPORT std::vector<double> clamped_knots(int degree, int control_points);

/// Tensor-product B-spline surface over [0, 1] x [0, 1] (paper, Eq. 5, with d for p).
struct GESTALT_EXPORT BsplineSurface {
  int degree = 2;                       ///< d in [1, BsplineBasis::largest_degree], of both directions
  std::vector<double> knots_xi;         ///< u + d + 1 of them
  std::vector<double> knots_eta;        ///< v + d + 1
  std::vector<Eigen::Vector3d> points;  ///< control points B_ij at [j * u + i]

  /// A point of the surface with its partial derivatives.
  struct Derivatives {
    Eigen::Vector3d point, xi, eta, xi_xi, xi_eta, eta_eta;
  };

  int columns() const { return int(knots_xi.size()) - degree - 1; }
  int rows() const { return int(knots_eta.size()) - degree - 1; }

  /// B_ij.
  const Eigen::Vector3d& control_point(int i, int j) const {
    return points[std::size_t(j) * std::size_t(columns()) + std::size_t(i)];
  }

  Eigen::Vector3d point(double xi, double eta) const;
  Derivatives derivatives(double xi, double eta) const;

  /// The same surface with one more knot in (0, 1) (Boehm's algorithm), which adds a column or a row of control points.
  void insert_knot_xi(double xi);
  void insert_knot_eta(double eta);
};

}  // namespace gestalt
