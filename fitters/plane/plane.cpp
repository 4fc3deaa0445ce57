// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "plane.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "gestalt/core/scene/moments.h"

namespace gestalt {

namespace {

class PlaneModel final : public SurfaceModel {
 public:
  PlaneModel(const Moments& moments, const Eigen::Vector3f& normal)
      : moments_(moments), normal_(normal), offset_(-normal.dot(moments.mean().cast<float>())) {}

  const Moments& moments() const { return moments_; }

  std::string type() const override { return "plane"; }
  Foot foot(const Eigen::Vector3f& p) const override { return {p - signed_distance(p) * normal_, normal_}; }
  float squared_distance(const Eigen::Vector3f& p) const override {
    const float d = signed_distance(p);
    return d * d;
  }
  std::optional<Eigen::Vector2d> parameters(const Eigen::Vector3f& p) const override {
    const Eigen::Vector3d d = p.cast<double>() - moments_.mean();
    return Eigen::Vector2d(d.dot(across()), d.dot(down()));
  }
  nlohmann::json to_json() const override {
    const auto list = [](const Eigen::Vector3d& v) { return nlohmann::json{float(v.x()), float(v.y()), float(v.z())}; };
    return {{"type", "plane"},          {"normal", list(normal_.cast<double>())},
            {"offset", offset_},        {"centre", list(moments_.mean())},
            {"across", list(across())}, {"down", list(down())}};
  }

 private:
  // Axes of the parameters: metres from the centre.
  Eigen::Vector3d across() const { return normal_.cast<double>().unitOrthogonal(); }
  Eigen::Vector3d down() const { return normal_.cast<double>().cross(across()).normalized(); }
  float signed_distance(const Eigen::Vector3f& p) const { return normal_.dot(p) + offset_; }

  Moments moments_;
  Eigen::Vector3f normal_;
  float offset_;
};

/// Of all unit vectors perpendicular to axis (or of all, when axis is 0), the one that faces the camera most.
Eigen::Vector3f facing_camera(const Eigen::Vector3d& centre, const Eigen::Vector3d& axis) {
  const Eigen::Vector3d view = centre.norm() > 0 ? -centre.normalized() : Eigen::Vector3d(0, 0, -1);
  Eigen::Vector3d normal = view - axis * axis.dot(view);
  if (normal.norm() < 1e-9) normal = axis.unitOrthogonal();
  return normal.normalized().cast<float>();
}

std::shared_ptr<const SurfaceModel> plane_of(const Moments& moments) {
  const Eigen::Matrix3d covariance = moments.covariance();
  const Eigen::Vector3d centre = moments.mean();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  const Eigen::Vector3d& spread = eigen.eigenvalues();

  // Rounding leaves a variance of about 1e-14 of the squared distance even where all points are equal.
  const double nothing = 1e-12 * (1 + centre.squaredNorm());
  if (spread[2] < nothing) return std::make_shared<PlaneModel>(moments, facing_camera(centre, Eigen::Vector3d::Zero()));
  if (spread[1] < nothing)
    return std::make_shared<PlaneModel>(moments, facing_camera(centre, eigen.eigenvectors().col(2)));

  Eigen::Vector3f normal = eigen.eigenvectors().col(0).cast<float>();
  if (normal.dot(centre.cast<float>()) > 0) normal = -normal;
  return std::make_shared<PlaneModel>(moments, normal);
}

}  // namespace

const Parameters<Plane::Params>& Plane::parameters() {
  static const auto parameters = Parameters<Params>().real("parameter_count", &Params::parameter_count, 1, 1000, "",
                                                           "cost of a plane in model selection, S_m of Eq. 3");
  return parameters;
}

std::shared_ptr<const SurfaceModel> Plane::fit(std::span<const Eigen::Vector3f> points) const {
  if (points.empty()) return nullptr;
  return plane_of(Moments(points));
}

std::shared_ptr<const SurfaceModel> Plane::fit_merged(const SurfaceModel& a, std::span<const Eigen::Vector3f> points_a,
                                                      const SurfaceModel& b,
                                                      std::span<const Eigen::Vector3f> points_b) const {
  const auto* plane_a = dynamic_cast<const PlaneModel*>(&a);
  const auto* plane_b = dynamic_cast<const PlaneModel*>(&b);
  if (!plane_a || !plane_b) return Fitter::fit_merged(a, points_a, b, points_b);
  return plane_of(plane_a->moments() + plane_b->moments());
}

}  // namespace gestalt
