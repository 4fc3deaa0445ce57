// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "closest_point.h"

#include <cmath>

namespace gestalt {

namespace {

constexpr int evaluations = 12;
constexpr double tolerance = 1e-4;  // of the parameters; the distance errs by the square of that

/// Gradient and Hessian of half the squared distance. At the border of the domain, a direction that leads out is
/// taken out of the system.
Eigen::Vector2d newton_step(const BsplineSurface::Derivatives& s, const Eigen::Vector3d& p, const Eigen::Vector2d& at) {
  const Eigen::Vector3d r = s.point - p;
  const Eigen::Vector2d gradient(r.dot(s.xi), r.dot(s.eta));
  const Eigen::Vector3d gauss(s.xi.squaredNorm(), s.xi.dot(s.eta), s.eta.squaredNorm());  // xx, xy, yy
  const Eigen::Vector3d full = gauss + Eigen::Vector3d(r.dot(s.xi_xi), r.dot(s.xi_eta), r.dot(s.eta_eta));

  const auto leads_out = [&](int i) { return (at[i] <= 0 && gradient[i] > 0) || (at[i] >= 1 && gradient[i] < 0); };
  const auto along = [](double slope, double newton, double gauss_newton) {
    const double curvature = newton > 0 ? newton : gauss_newton;
    return curvature > 0 ? -slope / curvature : 0.0;
  };
  if (leads_out(0) && leads_out(1)) return {0, 0};
  if (leads_out(0)) return {0, along(gradient[1], full[2], gauss[2])};
  if (leads_out(1)) return {along(gradient[0], full[0], gauss[0]), 0};

  const auto determinant = [](const Eigen::Vector3d& h) { return h[0] * h[2] - h[1] * h[1]; };
  const double smallest = 1e-12 * gauss[0] * gauss[2];  // below it a system is singular
  const Eigen::Vector3d& h = full[0] > 0 && determinant(full) > smallest ? full : gauss;
  const double d = determinant(h);
  if (!(d > smallest)) return {along(gradient[0], full[0], gauss[0]), along(gradient[1], full[2], gauss[2])};
  return {(h[1] * gradient[1] - h[2] * gradient[0]) / d, (h[1] * gradient[0] - h[0] * gradient[1]) / d};
}

Eigen::Vector2d clamped(const Eigen::Vector2d& at) { return at.cwiseMax(0.0).cwiseMin(1.0); }

}  // namespace

ClosestPoint newton(const BsplineSurface& surface, const Eigen::Vector3d& p, const Eigen::Vector2d& start) {
  BsplineSurface::Derivatives here = surface.derivatives(start.x(), start.y());
  ClosestPoint best{start, (here.point - p).squaredNorm(), false};
  Eigen::Vector2d step = newton_step(here, p, start);
  for (int i = 0; i < evaluations; ++i) {
    const Eigen::Vector2d next = clamped(best.parameters + step);
    if ((next - best.parameters).cwiseAbs().maxCoeff() < tolerance) {
      best.converged = true;
      return best;
    }
    const BsplineSurface::Derivatives there = surface.derivatives(next.x(), next.y());
    const double squared_distance = (there.point - p).squaredNorm();
    if (squared_distance < best.squared_distance) {
      best.parameters = next;
      best.squared_distance = squared_distance;
      step = newton_step(there, p, next);
    } else {
      step = (next - best.parameters) / 2;
    }
  }
  return best;
}

ClosestPoint closest_point(const BsplineSurface& surface, const Eigen::Vector3d& p, const Eigen::Vector2d& start) {
  ClosestPoint nearest = newton(surface, p, clamped(start));
  if (nearest.converged) return nearest;
  constexpr int steps = 8;
  for (int j = 0; j <= steps; ++j)
    for (int i = 0; i <= steps; ++i) {
      const Eigen::Vector2d place(double(i) / steps, double(j) / steps);
      const double squared_distance = (surface.point(place.x(), place.y()) - p).squaredNorm();
      if (squared_distance < nearest.squared_distance) nearest = {place, squared_distance, false};
    }
  return newton(surface, p, nearest.parameters);
}

}  // namespace gestalt
