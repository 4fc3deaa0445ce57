// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "tolerances.h"

#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

constexpr double largest_window = 64;  // px

}  // namespace

Tolerances::Tolerances(const Frame& frame, const ToleranceParams& params)
    : params_(params),
      noise_(frame.noise),
      focal_length_(std::sqrt(frame.camera.fx * frame.camera.fy)),
      scale_(std::sqrt(pixel_density(frame.camera))) {}

Tolerances Tolerances::halved() const {
  Tolerances half = *this;
  half.focal_length_ /= 2;
  return half;
}

double Tolerances::noise_in_pixels(float z) const { return noise_.at(z) * focal_length_ / double(z); }

int Tolerances::window_radius(float z) const {
  const double radius = std::max(params_.window_radius * scale_, params_.window_noise * noise_in_pixels(z));
  return int(std::lround(std::clamp(radius, 1.0, largest_window)));
}

float Tolerances::squared_reach(float z) const {
  const double reach = params_.neighbour_slope * double(z) / focal_length_;
  return float(reach * reach);
}

float Tolerances::distance(float z) const { return float(params_.distance + params_.distance_noise * noise_.at(z)); }

float Tolerances::cosine(float z) const {
  const double angle = params_.angle + params_.angle_noise * noise_in_pixels(z) / window_radius(z);
  return float(std::cos(std::min(angle, 3.14159265)));
}

int Tolerances::spur_radius() const {
  return params_.spur_radius > 0 ? int(std::lround(std::clamp(params_.spur_radius * scale_, 1.0, 1e6))) : 0;
}

int Tolerances::min_patch_size() const {
  return int(std::lround(std::clamp(params_.min_patch_size * scale_ * scale_, 1.0, 1e9)));
}

int Tolerances::smallest_island() const {
  return int(std::lround(std::min(params_.smallest_island * scale_ * scale_, 1e9)));
}

}  // namespace gestalt
