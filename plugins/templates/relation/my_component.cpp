#include "my_component.h"

#include <algorithm>
#include <cmath>

namespace {

/// Mean brightness of each surface, from 0 (black) to 1 (white).
std::vector<double> brightnesses(const gestalt::Scene& scene) {
  const uchar* grey = scene.grey().ptr();
  std::vector<double> all;
  for (const gestalt::Surface& surface : scene.surfaces().surfaces) {
    double sum = 0;
    for (const int pixel : surface.pixels) sum += grey[pixel];
    all.push_back(sum / (255.0 * double(surface.pixels.size())));
  }
  return all;
}

/// What is computed once for a scene is kept here; a pair is cheap, and must be symmetric.
class MyComponentMeasure final : public gestalt::Measure {
 public:
  MyComponentMeasure(const gestalt::Scene& scene, double contrast)
      : brightness_(brightnesses(scene)), contrast_(contrast) {}

  void operator()(const gestalt::SurfacePair& pair, std::span<double> values) const override {
    const double difference = brightness_[std::size_t(pair.a)] - brightness_[std::size_t(pair.b)];
    values[0] = std::min(1.0, contrast_ * std::abs(difference));
  }

 private:
  std::vector<double> brightness_;
  double contrast_;
};

}  // namespace

const gestalt::Parameters<MyComponent::Params>& MyComponent::parameters() {
  static const auto parameters =
      gestalt::Parameters<Params>().real("contrast", &Params::contrast, 0.1, 10, "", "factor of the difference");
  return parameters;
}

const std::vector<gestalt::RelationValue>& MyComponent::values() const {
  static const std::vector<gestalt::RelationValue> values{
      {"r_my_component", 0, 1, "difference of the patches' mean brightness, 0 for equally bright ones"}};
  return values;
}

std::unique_ptr<gestalt::Measure> MyComponent::bind(const gestalt::Scene& scene) const {
  return std::make_unique<MyComponentMeasure>(scene, params_.contrast);
}
