// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gabor.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "gestalt/core/base/error.h"

namespace gestalt {

namespace {

struct ObservedResponses final : Observation {
  explicit ObservedResponses(GaborResponses r) : responses(std::move(r)) {}
  GaborResponses responses;
};

class GaborMeasure final : public Measure {
 public:
  GaborMeasure(const Gabor::Params& params, const GaborResponses& responses, const SurfaceSet& surfaces)
      : params_(params), descriptors_(describe(params, responses, surfaces)) {
    for (const GaborDescriptor& d : descriptors_) {
      double energy = 0;
      for (std::size_t f = 0; f < params.filters(); ++f) energy += length(d.mean[f], d.deviation[f]);
      energies_.push_back(energy);
    }
  }

  void operator()(const SurfacePair& pair, std::span<double> values) const override {
    // In one order, so that rounding is symmetric too.
    const auto [a, b] = std::minmax({std::size_t(pair.a), std::size_t(pair.b)});
    double nearest = std::numeric_limits<double>::infinity();
    for (int shift = 0; shift < params_.directions; ++shift)
      nearest = std::min(nearest, distance(descriptors_[a], descriptors_[b], shift));
    values[0] = std::min(2.0, nearest / std::max({energies_[a], energies_[b], params_.least_energy}));
  }

 private:
  static double length(float mean, float deviation) { return std::sqrt(mean * mean + deviation * deviation); }

  double distance(const GaborDescriptor& a, const GaborDescriptor& b, int shift) const {
    double sum = 0;
    for (int scale = 0; scale < params_.scales; ++scale)
      for (int j = 0; j < params_.directions; ++j) {
        const std::size_t first = std::size_t(scale) * std::size_t(params_.directions);
        const std::size_t f = first + std::size_t(j), g = first + std::size_t((j + shift) % params_.directions);
        sum += length(a.mean[f] - b.mean[g], a.deviation[f] - b.deviation[g]);
      }
    return sum;
  }

  Gabor::Params params_;
  std::vector<GaborDescriptor> descriptors_;
  std::vector<double> energies_;
};

}  // namespace

const Parameters<Gabor::Params>& Gabor::parameters() {
  static const auto p =
      Parameters<Params>()
          .integer("directions", &Params::directions, 1, 32, "", "directions of a scale, evenly over half a turn")
          .integer("scales", &Params::scales, 1, 8, "", "scales of the filter bank")
          .real("shortest_wavelength", &Params::shortest_wavelength, 2, 64, "px", "wavelength of the finest scale")
          .real("spacing", &Params::spacing, 1, 4, "", "ratio of the wavelengths of neighbouring scales")
          .real("sigma", &Params::sigma, 1, 64, "rad", "standard deviation of the Gaussian times the wave number")
          .real("truncation", &Params::truncation, 1, 6, "", "kernel radius in standard deviations of the Gaussian")
          .integer("stride", &Params::stride, 1, 16, "px", "responses are taken on every stride-th row and column")
          .real("least_energy", &Params::least_energy, 1e-6, 1e6, "grey levels",
                "energy of the camera's noise: the distance is divided by at least this");
  return p;
}

const std::vector<RelationValue>& Gabor::values() const {
  static const std::vector<RelationValue> values{
      {"r_ga", 0, 2, "distance of the Gabor features over the larger energy, 0 for equal or equally plain textures"}};
  return values;
}

Gabor::Gabor(const Params& params) : params_(params) {
  constexpr int largest = 256;
  const int radius = params.radius(params.scales - 1);
  if (radius > largest)
    throw ConfigError("gabor: the coarsest kernel has a radius of " + std::to_string(radius) + " px and may have " +
                      std::to_string(largest) + "; lower scales, spacing, shortest_wavelength, sigma or truncation");
}

std::unique_ptr<Observation> Gabor::observe(const Images& images) const {
  return std::make_unique<ObservedResponses>(
      GaborResponses(params_, images.grey(), grid_box(images.frame().depth > 0, params_.stride)));
}

std::unique_ptr<Measure> Gabor::bind(const Scene& scene) const {
  const GaborResponses& observed = scene.observed<ObservedResponses>(*this).responses;
  // A clusterer may have put pixels without depth into patches.
  const cv::Rect box = grid_box(scene.surfaces().labels > 0, params_.stride);
  if ((box | observed.box()) == observed.box())
    return std::make_unique<GaborMeasure>(params_, observed, scene.surfaces());
  return std::make_unique<GaborMeasure>(params_, GaborResponses(params_, scene.grey(), box), scene.surfaces());
}

}  // namespace gestalt
