// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "kinect.h"

#include <algorithm>
#include <cmath>

#include "depth_jumps.h"
#include "smooth_noise.h"

namespace gestalt::synthesis {

namespace {

constexpr double baseline = projector_x - infrared_camera_x;

/// The depth that comes out for a true depth with this error in disparity (pixels).
double measured_depth(double depth, double error) {
  const double disparity = infrared_focal_length * baseline / depth + error;
  const double quantised = disparity_step * std::round(disparity / disparity_step);
  return infrared_focal_length * baseline / std::max(quantised, disparity_step);
}

/// Share of lost pixels by the angle between ray and normal: none up to 75 degrees, all from 86.5 on.
double lost_at(double slant) {
  constexpr double none = 0.26, all = 0.06;  // cosines
  return std::clamp((none - slant) / (none - all), 0.0, 1.0);
}

}  // namespace

double depth_step(double z) { return z * z * disparity_step / (infrared_focal_length * baseline); }

Measurement measure_structured_light(const IdealView& view, const Camera& camera, Random& random) {
  const cv::Size size = view.depth.size();
  // The correlation window of the sensor and the jitter are in pixels of its own image, 525 to the radian.
  const double pixel = std::max(camera.fx / 525, 0.3);
  const cv::Mat_<float> disparity_noise = smooth_noise(size, 1.4 * pixel, random);
  const cv::Mat_<float> shift_u = smooth_noise(size, 2 * pixel, random);
  const cv::Mat_<float> shift_v = smooth_noise(size, 2 * pixel, random);
  const cv::Mat_<float> loss = smooth_noise(size, 1.2 * pixel, random);
  cv::Mat_<float> seen(size, 0.f);
  view.depth.copyTo(seen, view.measurable);
  const cv::Mat_<uchar> beside = beside_jumps(seen, std::max(1, int(std::lround(2 * pixel))));
  const double beside_loss = random.uniform(0.02, 0.12);
  // Registration leaves a border of the colour image without depth, mostly on the right.
  const int left = int(random.uniform(0, 0.02) * size.width), top = int(random.uniform(0, 0.02) * size.height);
  const int right = size.width - int(random.uniform(0, 0.08) * size.width);
  const int bottom = size.height - int(random.uniform(0, 0.02) * size.height);

  Measurement measurement{{size, std::uint16_t(0)}, {size, IdealView::nothing}};
  for (int v = top; v < bottom; ++v)
    for (int u = left; u < right; ++u) {
      const double jitter = beside(v, u) ? lateral_deviation * pixel : 0.0;
      const int s = std::clamp(u + int(std::lround(jitter * double(shift_u(v, u)))), 0, size.width - 1);
      const int t = std::clamp(v + int(std::lround(jitter * double(shift_v(v, u)))), 0, size.height - 1);
      if (!view.measurable(t, s)) continue;
      const cv::Vec3f& colour = view.colour(t, s);
      const bool black = std::max({colour[0], colour[1], colour[2]}) < 12;
      const double kept =
          (1 - lost_at(double(view.slant(t, s)))) * (beside(v, u) ? 1 - beside_loss : 1.0) * (black ? 0.7 : 1.0);
      if (kept < 1 && loss(v, u) > exceeded_with(1 - kept)) continue;
      const double depth =
          measured_depth(double(view.depth(t, s)), disparity_deviation * double(disparity_noise(v, u)));
      const long millimetres = std::lround(1000 * depth);
      if (millimetres > 65535) continue;
      measurement.depth(v, u) = std::uint16_t(millimetres);
      measurement.body(v, u) = view.body(t, s);
    }
  return measurement;
}

}  // namespace gestalt::synthesis
