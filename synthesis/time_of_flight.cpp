// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "time_of_flight.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "depth_jumps.h"
#include "smooth_noise.h"

namespace gestalt::synthesis {

namespace {

float brightness_at(const IdealView& view, int v, int u) {
  const cv::Vec3f& colour = view.colour(v, u);
  return std::max((colour[0] + colour[1] + colour[2]) / (3 * 255), 0.01f);
}

/// What comes back of the sensor's light: 1 from a white surface that faces it at 1 m.
float signal_at(const IdealView& view, int v, int u) {
  const float z = view.depth(v, u);
  return z > 0 ? brightness_at(view, v, u) * view.slant(v, u) / (z * z) : 0.f;
}

/// What differs from device to device, with its mode and the scene.
struct Settings {
  double noise;          // times time_of_flight_deviation()
  double noise_radius;   // pixels
  double multipath;      // times multipath()
  double least_signal;   // as signal_at()
  double lost_at_jumps;  // share
};

Settings draw_settings(double pixel, Random& random) {
  Settings settings;
  settings.noise = random.uniform(0.7, 2);
  settings.noise_radius = pixel * random.uniform(0.8, 2.4);
  settings.multipath = random.uniform(0.3, 1.3);
  settings.least_signal = 0.006 * std::pow(8, random.uniform());
  settings.lost_at_jumps = random.uniform(0.1, 0.6);
  return settings;
}

/// The depth camera's field as the colour camera sees it.
class Field {
 public:
  Field(const Camera& camera, Random& random) : camera_(camera) {
    const double shape = random.uniform();
    corner_ = shape < 0.35 ? 2.0 : random.uniform(1.25, 1.55);
    round_ = shape > 0.75;
    // A narrow field leaves the colour image's sides bare, a wide one touches its corners at most.
    const double width = random.uniform(0.8, 1.25), height = random.uniform(0.92, 1.3);
    half_width_ = width * camera.width / 2 / camera.fx;
    half_height_ = height * camera.height / 2 / camera.fy;
    radius_ = random.uniform(0.85, 1.2) * std::max(camera.width / camera.fx, camera.height / camera.fy) / 2;
    // The depth camera of an Azure Kinect looks 6 degrees further down.
    down_ = random.uniform(0, 0.1);
    if (shape < 0.35) half_width_ *= 1.15;
  }
  bool contains(int u, int v) const {
    const double x = (u - camera_.cx) / camera_.fx, y = (v - camera_.cy) / camera_.fy - down_;
    if (round_) return x * x + y * y < radius_ * radius_;
    const double a = std::abs(x) / half_width_, b = std::abs(y) / half_height_;
    return a < 1 && b < 1 && a + b < corner_;
  }

 private:
  Camera camera_;
  double corner_, half_width_, half_height_, radius_, down_;
  bool round_;
};

/// A piece of surface in the camera's frame.
struct Facet {
  Eigen::Vector3f point, normal;
  float range, facing;  // distance from the camera in metres, cosine towards it
  float area;           // square metres
  float reflectance;
};

/// The facet of a pixel of the coarse grid; reflectance 0 where there is no surface.
Facet facet_at(const IdealView& view, const Camera& camera, int u, int v, int step) {
  const auto point_at = [&](int x, int y) -> Eigen::Vector3f {
    x = std::clamp(x, 0, camera.width - 1);
    y = std::clamp(y, 0, camera.height - 1);
    const float z = view.depth(y, x);
    return {float((x - camera.cx) / camera.fx) * z, float((y - camera.cy) / camera.fy) * z, z};
  };
  Facet facet{point_at(u, v), Eigen::Vector3f::Zero(), 0, 0, 0, 0};
  const Eigen::Vector3f right = point_at(u + 1, v) - point_at(u - 1, v);
  const Eigen::Vector3f down = point_at(u, v + 1) - point_at(u, v - 1);
  const float z = facet.point.z();
  if (z <= 0 || std::max(std::abs(right.z()), std::abs(down.z())) > 0.03f * z) return facet;
  facet.range = facet.point.norm();
  facet.normal = down.cross(right).normalized();
  facet.facing = -facet.normal.dot(facet.point) / facet.range;
  if (facet.facing < 0.05f) return facet;
  facet.area = float(step * step / (camera.fx * camera.fy)) * z * z * (facet.range / z) / facet.facing;
  facet.reflectance = brightness_at(view, v, u);
  return facet;
}

/// multipath() of each facet.
std::vector<float> excess_of(const std::vector<Facet>& facets) {
  constexpr float farthest = 0.6f;  // metres: light over surfaces farther off is too weak
  std::vector<float> excesses(facets.size(), 0.f);
  for (std::size_t i = 0; i < facets.size(); ++i) {
    const Facet& here = facets[i];
    if (here.reflectance == 0) continue;
    const float direct = here.facing / (here.range * here.range);
    float excess = 0, indirect = 0;
    for (const Facet& there : facets) {
      if (there.reflectance == 0) continue;
      const Eigen::Vector3f way = there.point - here.point;
      const float squared = way.squaredNorm();
      if (squared > farthest * farthest || squared < 1e-8f) continue;
      const float out = way.dot(here.normal), in = -way.dot(there.normal);
      if (out <= 0 || in <= 0) continue;
      // The share of the light that leaves one for the other, in comparison with what is lit directly.
      const float exchange = out * in * there.area / (float(CV_PI) * squared * std::max(squared, there.area));
      const float light = there.reflectance * exchange * there.facing / (there.range * there.range) / direct;
      const float detour = (std::sqrt(squared) + there.range - here.range) / 2;
      indirect += light;
      excess += light * detour;
    }
    const float range = excess / (1 + indirect);
    excesses[i] = std::clamp(range, 0.f, 0.05f) * here.point.z() / here.range;
  }
  return excesses;
}

/// The mean depth around a jump, weighted by the light that comes back: the pixel sees both surfaces.
float mixed_depth(const IdealView& view, int u, int v, int radius) {
  float sum = 0, weights = 0;
  for (int y = std::max(0, v - radius); y <= std::min(view.depth.rows - 1, v + radius); ++y)
    for (int x = std::max(0, u - radius); x <= std::min(view.depth.cols - 1, u + radius); ++x) {
      const float distance = float((x - u) * (x - u) + (y - v) * (y - v)) / float(radius * radius);
      const float weight = signal_at(view, y, x) / (1 + 2 * distance);
      sum += weight * view.depth(y, x);
      weights += weight;
    }
  return weights > 0 ? sum / weights : view.depth(v, u);
}

}  // namespace

double time_of_flight_deviation(double z) { return 0.0005 + 0.001 * z; }

cv::Mat_<float> multipath(const IdealView& view, const Camera& camera) {
  const int step = std::max(4, (camera.width + 63) / 64);
  const cv::Size grid((camera.width + step - 1) / step, (camera.height + step - 1) / step);
  std::vector<Facet> facets;
  for (int row = 0; row < grid.height; ++row)
    for (int column = 0; column < grid.width; ++column)
      facets.push_back(facet_at(view, camera, column * step + step / 2, row * step + step / 2, step));

  const std::vector<float> coarse = excess_of(facets);
  cv::Mat_<float> bias(view.depth.size(), 0.f);
  for (int v = 0; v < bias.rows; ++v)
    for (int u = 0; u < bias.cols; ++u) {
      const float z = view.depth(v, u);
      if (z <= 0) continue;
      const Eigen::Vector3f point(float((u - camera.cx) / camera.fx) * z, float((v - camera.cy) / camera.fy) * z, z);
      // Bilinear, but of facets in whose plane the point lies.
      const float x = (float(u) - float(step / 2)) / float(step), y = (float(v) - float(step / 2)) / float(step);
      const int left = int(std::floor(x)), top = int(std::floor(y));
      float sum = 0, weights = 0;
      for (int row = std::max(0, top); row <= std::min(top + 1, grid.height - 1); ++row)
        for (int column = std::max(0, left); column <= std::min(left + 1, grid.width - 1); ++column) {
          const auto index = std::size_t(row * grid.width + column);
          const Facet& facet = facets[index];
          if (facet.reflectance == 0) continue;
          const float off_plane = facet.normal.dot(point - facet.point) / 0.005f;
          const float near = (1 - std::abs(x - float(column))) * (1 - std::abs(y - float(row)));
          const float weight = (near + 1e-3f) / (1 + off_plane * off_plane);
          sum += weight * coarse[index];
          weights += weight;
        }
      bias(v, u) = weights > 0 ? sum / weights : 0.f;
    }
  return bias;
}

Measurement measure_time_of_flight(const IdealView& view, const Camera& camera, Random& random) {
  const cv::Size size = view.depth.size();
  const double pixel = std::max(camera.fx / time_of_flight_focal_length, 0.3);  // of the depth camera
  const Settings settings = draw_settings(pixel, random);
  const Field field(camera, random);
  const cv::Mat_<float> noise = smooth_noise(size, settings.noise_radius, random);
  const cv::Mat_<float> grain = smooth_noise(size, 0.6, random);
  const cv::Mat_<float> loss = smooth_noise(size, 0.6 * pixel, random);
  const cv::Mat_<float> speckle = smooth_noise(size, 0.7 * pixel, random);
  const cv::Mat_<float> bias = multipath(view, camera);
  const int radius = std::max(1, int(std::lround(pixel)));
  const cv::Mat_<uchar> beside = beside_jumps(view.depth, radius);
  // The device's own smoothing; 1 cm does not count as a jump.
  const cv::Mat_<float> smoothed = window_mean(view.depth, radius, 0.01f);

  Measurement measurement{{size, std::uint16_t(0)}, {size, IdealView::nothing}};
  for (int v = 0; v < size.height; ++v)
    for (int u = 0; u < size.width; ++u) {
      if (!view.measurable(v, u) || !field.contains(u, v)) continue;
      const float signal = signal_at(view, v, u);
      if (double(signal) * std::exp(0.4 * double(speckle(v, u))) < settings.least_signal) continue;
      double depth = double(smoothed(v, u));
      if (beside(v, u)) {
        if (loss(v, u) > exceeded_with(settings.lost_at_jumps)) continue;
        depth = double(mixed_depth(view, u, v, radius));
      }
      depth += settings.multipath * double(bias(v, u));
      // Less light, more noise: as 1 / its root while the sensor's own light is most of it.
      const double weak = std::clamp(std::sqrt(0.25 / double(signal)), 0.7, 2.5);
      depth += settings.noise * weak * time_of_flight_deviation(depth) *
               (0.9 * double(noise(v, u)) + 0.44 * double(grain(v, u)));
      const long millimetres = std::lround(1000 * depth);
      if (millimetres < 100 || millimetres > 65535) continue;
      measurement.depth(v, u) = std::uint16_t(millimetres);
      measurement.body(v, u) = view.body(v, u);
    }
  return measurement;
}

}  // namespace gestalt::synthesis
