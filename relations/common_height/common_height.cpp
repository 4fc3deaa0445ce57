// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "common_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

constexpr std::size_t samples = 1000;
constexpr double top_share = 0.97;

/// Normal of the largest surface where its middle pixel is.
Eigen::Vector3f up_of(const Scene& scene) {
  const std::vector<Surface>& surfaces = scene.surfaces().surfaces;
  const auto smaller = [](const Surface& x, const Surface& y) {
    return x.pixels.size() != y.pixels.size() ? x.pixels.size() < y.pixels.size() : x.pixels.front() > y.pixels.front();
  };
  const Surface& largest = *std::max_element(surfaces.begin(), surfaces.end(), smaller);
  return largest.model->foot(scene.frame().point(largest.pixels[largest.pixels.size() / 2])).normal;
}

double top_of(const Frame& frame, const Surface& surface, const Eigen::Vector3f& up) {
  const std::size_t step = (surface.pixels.size() + samples - 1) / samples;
  std::vector<float> heights;
  for (std::size_t i = 0; i < surface.pixels.size(); i += step)
    heights.push_back(up.dot(frame.point(surface.pixels[i])));
  const auto top = heights.begin() + std::ptrdiff_t(top_share * double(heights.size()));
  std::nth_element(heights.begin(), top, heights.end());
  return double(*top);
}

class CommonHeightMeasure final : public Measure {
 public:
  explicit CommonHeightMeasure(const Scene& scene) {
    if (scene.surfaces().surfaces.empty()) return;
    const Eigen::Vector3f up = up_of(scene);
    for (const Surface& surface : scene.surfaces().surfaces) tops_.push_back(top_of(scene.frame(), surface, up));
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    values[0] = std::abs(tops_[std::size_t(pair.a)] - tops_[std::size_t(pair.b)]);
  }

 private:
  std::vector<double> tops_;
};

}  // namespace

const Parameters<CommonHeight::Params>& CommonHeight::parameters() {
  static const Parameters<Params> parameters;
  return parameters;
}

const std::vector<RelationValue>& CommonHeight::values() const {
  static const std::vector<RelationValue> values{{"r_th", 0, std::numeric_limits<double>::infinity(),
                                                  "difference of the heights at which the patches end above, m"}};
  return values;
}

std::unique_ptr<Measure> CommonHeight::bind(const Scene& scene) const {
  return std::make_unique<CommonHeightMeasure>(scene);
}

}  // namespace gestalt
