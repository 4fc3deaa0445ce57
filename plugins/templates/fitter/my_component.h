#pragma once

#include <gestalt/core/plugin/fitter.h>
#include <gestalt/core/plugin/parameters.h>

/// The plane through the mean of the points, perpendicular to the direction in which they spread least.
class MyComponent final : public gestalt::Fitter {
 public:
  struct Params {
    double parameter_count = 12;  ///< S_m of the paper's Eq. 3; plane counts 12 and bspline 27
  };
  static const gestalt::Parameters<Params>& parameters();

  explicit MyComponent(const Params& params) : params_(params) {}
  double parameter_count() const override { return params_.parameter_count; }
  std::shared_ptr<const gestalt::SurfaceModel> fit(std::span<const Eigen::Vector3f> points) const override;
  std::string refusal(std::span<const Eigen::Vector3f> points) const override;

 private:
  Params params_;
};
