// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "active_stereo.h"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "depth_jumps.h"
#include "smooth_noise.h"

namespace gestalt::synthesis {

namespace {

constexpr double finest_step = 1.0 / 32;  // pixels: the device interpolates disparities to this
constexpr double nearest = 0.2;           // metres: larger disparities are not searched
constexpr double farthest = 10;

/// What differs from device to device, with its settings and with the light.
struct Settings {
  double window;           // half the matching window, pixels of the colour camera as all lengths here
  double tolerance;        // surfaces whose disparities (pixels) differ by less are one to a window
  double fattening;        // how far near surfaces grow over farther ones
  double deviation;        // of disparity, pixels
  double bump;             // radius of the noise's bumps
  double grain;            // share of the deviation that neighbours hardly share
  double lost_at_jumps;    // share
  double lost_on_plain;    // share lost on surfaces without texture: much where daylight drowns the projector
  double lost_in_patches;  // share
  double half_field;       // tangent of the right imager's view to the left
  bool fills_holes;
};

Settings draw_settings(const Camera& camera, double pixel, Random& random) {
  Settings settings;
  settings.window = pixel * random.uniform(1.5, 5);
  settings.tolerance = random.uniform(0.5, 1.5);
  settings.fattening = pixel * random.uniform(0.5, 2.5);
  // 0.08 is what Intel gives for a textured wall (Grunnet-Jepsen et al., Best-known methods for tuning Intel RealSense
  // D400 depth cameras, 2018).
  settings.deviation = random.uniform(0.03, 0.1);
  settings.bump = pixel * random.uniform(2.5, 8);
  settings.grain = random.uniform(0.03, 0.25);
  settings.lost_at_jumps = random.chance(0.3) ? 0.0 : random.uniform(0, 0.4);
  settings.lost_on_plain = random.chance(0.15) ? random.uniform(0.02, 0.25) : 0.0;
  settings.lost_in_patches = random.chance(0.5) ? random.uniform(0, 0.006) : 0.0;
  settings.half_field = camera.cx / camera.fx * random.uniform(0.98, 1.12);
  settings.fills_holes = random.chance(0.125);
  return settings;
}

/// Disparities and the bodies they are of; 0 and nothing where there are none.
struct Matches {
  cv::Mat_<float> disparity;
  cv::Mat_<int> body;
};

Matches true_matches(const IdealView& view) {
  Matches matches{{view.depth.size(), 0.f}, {view.depth.size(), IdealView::nothing}};
  for (int v = 0; v < view.depth.rows; ++v)
    for (int u = 0; u < view.depth.cols; ++u)
      if (view.measurable(v, u)) {
        matches.disparity(v, u) = float(stereo_constant) / view.depth(v, u);
        matches.body(v, u) = view.body(v, u);
      }
  return matches;
}

/// A window at a jump sees both surfaces and takes the nearer one: that grows by up to `reach`, which wanders along the
/// outline.
Matches fattened(const Matches& matches, const cv::Mat_<uchar>& beside, double reach, const cv::Mat_<float>& wander) {
  Matches result{matches.disparity.clone(), matches.body.clone()};
  const cv::Rect image({0, 0}, beside.size());
  for (int v = 0; v < beside.rows; ++v)
    for (int u = 0; u < beside.cols; ++u) {
      if (!beside(v, u)) continue;
      const double radius = std::clamp(reach * (1 + 0.6 * double(wander(v, u))), 0.0, 3 * reach);
      const int r = int(radius);
      for (int dv = -r; dv <= r; ++dv)
        for (int du = -r; du <= r; ++du) {
          const cv::Point at(u + du, v + dv);
          if (du * du + dv * dv > radius * radius || !image.contains(at)) continue;
          if (matches.disparity(at) <= result.disparity(v, u)) continue;
          result.disparity(v, u) = matches.disparity(at);
          result.body(v, u) = matches.body(at);
        }
    }
  return result;
}

/// Deviation of the brightness in a window.
cv::Mat_<float> texture_of(const cv::Mat_<float>& brightness, int radius) {
  const cv::Size window(2 * radius + 1, 2 * radius + 1);
  cv::Mat_<float> mean, squares;
  cv::blur(brightness, mean, window);
  cv::blur(brightness.mul(brightness), squares, window);
  cv::Mat_<float> deviation;
  cv::sqrt(cv::max(squares - mean.mul(mean), 0.f), deviation);
  return deviation;
}

/// Share of lost pixels by the angle between ray and normal: none up to 82 degrees, all from 88.5 on.
double lost_at(double slant) {
  constexpr double none = 0.14, all = 0.026;  // cosines
  return std::clamp((none - slant) / (none - all), 0.0, 1.0);
}

void fill_from_the_left(Measurement& measurement, const cv::Mat_<int>& body) {
  for (int v = 0; v < body.rows; ++v)
    for (int u = 1; u < body.cols; ++u)
      if (!measurement.depth(v, u) && body(v, u) != IdealView::nothing && measurement.depth(v, u - 1)) {
        measurement.depth(v, u) = measurement.depth(v, u - 1);
        measurement.body(v, u) = measurement.body(v, u - 1);
      }
}

}  // namespace

double stereo_deviation(double z, double disparity_deviation) { return z * z * disparity_deviation / stereo_constant; }

Measurement measure_active_stereo(const IdealView& view, const Camera& camera, Random& random) {
  const cv::Size size = view.depth.size();
  // The settings below are fitted to frames of a D435 whose colour camera has this focal length.
  const double pixel = std::max(camera.fx / 613, 0.3);
  const Settings settings = draw_settings(camera, pixel, random);
  const cv::Mat_<float> wander = smooth_noise(size, 3 * pixel, random);
  const cv::Mat_<float> grain = smooth_noise(size, 0.7 * pixel, random);
  const cv::Mat_<float> bumps = broad_noise(size, settings.bump, random);
  const cv::Mat_<float> waves = broad_noise(size, 20 * pixel, random);
  const cv::Mat_<float> loss = smooth_noise(size, 2.5 * pixel, random);
  const cv::Mat_<float> patches = broad_noise(size, 8 * pixel, random);

  Matches matches = true_matches(view);
  cv::Mat_<float> seen(size, 0.f);
  view.depth.copyTo(seen, view.measurable);
  const cv::Mat_<uchar> beside = beside_jumps(seen, std::max(1, int(std::lround(settings.fattening + pixel))));
  const cv::Mat_<uchar> at_jump = beside_jumps(seen, std::max(1, int(std::lround(0.6 * pixel))));
  matches = fattened(matches, beside, settings.fattening, wander);
  // Twice: the middle of a window weighs more than its rim.
  for (int pass = 0; pass < 2; ++pass)
    matches.disparity = window_mean(matches.disparity, int(std::lround(settings.window)), float(settings.tolerance));

  cv::Mat_<float> brightness;
  cv::transform(view.colour, brightness, cv::Matx13f(1 / 3.f, 1 / 3.f, 1 / 3.f));
  const cv::Mat_<float> texture = texture_of(brightness, std::max(1, int(std::lround(4 * pixel))));

  Measurement measurement{{size, std::uint16_t(0)}, {size, IdealView::nothing}};
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      const double disparity = double(matches.disparity(v, u));
      if (disparity <= 0) continue;
      // x in the right imager is that in the colour camera less its place.
      const double z = stereo_constant / disparity;
      if ((u - camera.cx) / camera.fx - right_imager_x / z < -settings.half_field) continue;
      const double slant = double(view.slant(v, u));
      const double dark = std::clamp((22 - double(brightness(v, u))) / 22, 0.0, 1.0);
      const double kept = (1 - lost_at(std::max(slant, beside(v, u) ? 0.14 : 0.0))) * (1 - 0.6 * dark) *
                          (at_jump(v, u) ? 1 - settings.lost_at_jumps : 1.0);
      if (kept < 1 && loss(v, u) > exceeded_with(1 - kept)) continue;
      const double lost = settings.lost_in_patches + (texture(v, u) < 1.2f ? settings.lost_on_plain : 0.0);
      if (lost > 0 && patches(v, u) > exceeded_with(lost)) continue;
      const double noise =
          settings.grain * double(grain(v, u)) + 0.9 * double(bumps(v, u)) + 0.36 * double(waves(v, u));
      // A slanted surface differs more between the two views.
      const double rough = (1 + 0.7 * dark) / std::sqrt(std::clamp(slant, 0.3, 1.0));
      const double error = settings.deviation * rough * noise;
      const double quantised = finest_step * std::round((disparity + error) / finest_step);
      const double depth = stereo_constant / std::max(quantised, finest_step);
      if (depth < nearest || depth > farthest) continue;
      measurement.depth(v, u) = std::uint16_t(std::lround(1000 * depth));
      measurement.body(v, u) = matches.body(v, u);
    }
  if (settings.fills_holes) fill_from_the_left(measurement, view.body);
  return measurement;
}

}  // namespace gestalt::synthesis
