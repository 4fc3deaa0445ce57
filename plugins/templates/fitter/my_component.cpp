#include "my_component.h"

#include <Eigen/Eigenvalues>
#include <nlohmann/json.hpp>

namespace {

class MyComponentModel final : public gestalt::SurfaceModel {
 public:
  MyComponentModel(const Eigen::Vector3f& centre, const Eigen::Vector3f& normal) : centre_(centre), normal_(normal) {}

  std::string type() const override { return "my_component"; }
  Foot foot(const Eigen::Vector3f& p) const override { return {p - normal_.dot(p - centre_) * normal_, normal_}; }
  nlohmann::json to_json() const override {
    const auto list = [](const Eigen::Vector3f& v) { return nlohmann::json{v.x(), v.y(), v.z()}; };
    return {{"type", type()}, {"centre", list(centre_)}, {"normal", list(normal_)}};
  }

 private:
  Eigen::Vector3f centre_, normal_;
};

/// Where the points are, and how they spread.
struct Spread {
  Eigen::Vector3d mean;
  Eigen::Vector3d variances;   ///< ascending
  Eigen::Matrix3d directions;  ///< a column for each variance

  explicit Spread(std::span<const Eigen::Vector3f> points) : mean(Eigen::Vector3d::Zero()) {
    for (const Eigen::Vector3f& p : points) mean += p.cast<double>() / double(points.size());
    Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
    for (const Eigen::Vector3f& p : points) {
      const Eigen::Vector3d d = p.cast<double>() - mean;
      covariance += d * d.transpose() / double(points.size());
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
    variances = eigen.eigenvalues();
    directions = eigen.eigenvectors();
  }
};

std::string why_not(std::span<const Eigen::Vector3f> points, const Spread& spread) {
  if (points.size() < 3) return "fewer than 3 points";
  return spread.variances[1] < 1e-10 ? "collinear points" : "";
}

}  // namespace

const gestalt::Parameters<MyComponent::Params>& MyComponent::parameters() {
  static const auto parameters = gestalt::Parameters<Params>().real("parameter_count", &Params::parameter_count, 1,
                                                                    1000, "", "cost in model selection, S_m of Eq. 3");
  return parameters;
}

std::shared_ptr<const gestalt::SurfaceModel> MyComponent::fit(std::span<const Eigen::Vector3f> points) const {
  const Spread spread(points);
  if (!why_not(points, spread).empty()) return nullptr;
  Eigen::Vector3d normal = spread.directions.col(0);
  if (normal.dot(spread.mean) > 0) normal = -normal;  // towards the camera
  return std::make_shared<MyComponentModel>(spread.mean.cast<float>(), normal.cast<float>());
}

std::string MyComponent::refusal(std::span<const Eigen::Vector3f> points) const {
  return why_not(points, Spread(points));
}
