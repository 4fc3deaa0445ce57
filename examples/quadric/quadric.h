// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gestalt/core/plugin/fitter.h>
#include <gestalt/core/plugin/parameters.h>

/// A quadratic height over the plane through the points: bent as a mug's wall is, for fewer parameters than a B-spline.
class Quadric final : public gestalt::Fitter {
 public:
  struct Params {
    double parameter_count = 15;  ///< S_m of the paper's Eq. 3; plane counts 12 and bspline 27
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit Quadric(const Params& params) : params_(params) {}
  double parameter_count() const override { return params_.parameter_count; }
  std::shared_ptr<const gestalt::SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override;
  std::string refusal(std::span<const Eigen::Vector3f> points) const override;

 private:
  Params params_;
};
