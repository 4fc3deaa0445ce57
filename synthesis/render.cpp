// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "render.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <opencv2/imgproc.hpp>

#include "ray_caster.h"
#include "sensor.h"

namespace gestalt::synthesis {

namespace {

constexpr int pattern = 5;  // the lamp is sampled by pattern x pattern points, each pixel of a block taking one

/// The exponent of highlights (Blinn, Models of light reflection for computer synthesized pictures, 1977): 6 degrees
/// wide.
constexpr float sharpness = 120;

/// Points spread evenly over the lamp's disc.
std::array<Eigen::Vector3f, pattern * pattern> points_on(const Lighting& lighting) {
  std::array<Eigen::Vector3f, pattern * pattern> points;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const double radius = lighting.lamp_radius * std::sqrt((double(i) + 0.5) / double(points.size()));
    const double angle = double(i) * std::numbers::pi * (3 - std::sqrt(5.0));
    points[i] = (lighting.lamp + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0)).cast<float>();
  }
  return points;
}

/// Averages the light over the pattern around each pixel, on one body and near in depth: shadows without noise.
cv::Mat_<float> smooth_light(const cv::Mat_<float>& lit, const cv::Mat_<int>& body, const cv::Mat_<float>& distance) {
  cv::Mat_<float> smooth;
  cv::boxFilter(lit, smooth, -1, {pattern, pattern}, {-1, -1}, true, cv::BORDER_REPLICATE);
  constexpr int reach = pattern / 2;
  for (int v = 0; v < lit.rows; ++v)
    for (int u = 0; u < lit.cols; ++u) {
      if (smooth(v, u) <= 0 || smooth(v, u) >= 1) continue;  // all dark or all lit
      float sum = 0;
      int count = 0;
      const int last_row = std::min(lit.rows - 1, v + reach), last_column = std::min(lit.cols - 1, u + reach);
      for (int y = std::max(0, v - reach); y <= last_row; ++y)
        for (int x = std::max(0, u - reach); x <= last_column; ++x)
          if (body(y, x) == body(v, u) && std::abs(distance(y, x) - distance(v, u)) < 0.03f) {
            sum += lit(y, x);
            ++count;
          }
      smooth(v, u) = sum / float(count);
    }
  return smooth;
}

}  // namespace

IdealView render(const Arrangement& arrangement, SensorModel sensor) {
  std::vector<const Body*> bodies{&arrangement.table};
  for (const Body& thing : arrangement.things) bodies.push_back(&thing);
  const int surroundings = int(bodies.size());
  for (const Body& body : arrangement.surroundings) bodies.push_back(&body);
  const int furniture = int(bodies.size());
  for (const Body& body : arrangement.furniture) bodies.push_back(&body);
  const RayCaster caster(bodies);

  const Camera& camera = arrangement.viewpoint.camera;
  const Eigen::Isometry3f pose = arrangement.viewpoint.pose.cast<float>();
  const Eigen::Vector3f eye = pose.translation();
  std::vector<Eigen::Vector3f> sensor_eyes;
  for (const double x : eyes_of(sensor)) sensor_eyes.push_back(pose * Eigen::Vector3f(float(x), 0, 0));
  const Lighting& lighting = arrangement.lighting;
  const auto lamp_points = points_on(lighting);

  const cv::Size size(camera.width, camera.height);
  IdealView view{{size, cv::Vec3f(0, 0, 0)}, {size, IdealView::nothing}, {size, 0.f}, {size, 0.f}, {size, uchar(0)}};
  cv::Mat_<cv::Vec3f> albedo(size, cv::Vec3f(0, 0, 0));
  cv::Mat_<float> lamp(size, 0.f), shine(size, 0.f), rest(size, 0.f), lit(size, 1.f), distance(size, 0.f);
  cv::Mat_<int> surface(size, -1);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const Eigen::Vector3f ray(float((u - camera.cx) / camera.fx), float((v - camera.cy) / camera.fy), 1);
      const Eigen::Vector3f direction = pose.linear() * ray;
      const Hit hit = caster.cast(eye, direction);
      if (hit.body < 0) continue;
      const Eigen::Vector3f point = eye + hit.distance * direction;
      const float slant = -hit.normal.dot(direction) / ray.norm();
      surface(v, u) = hit.body;
      distance(v, u) = hit.distance;  // the ray's z is 1
      if (hit.body < surroundings || hit.body >= furniture) {
        view.body(v, u) = hit.body < surroundings ? hit.body : IdealView::first_furniture - (hit.body - furniture);
        view.depth(v, u) = hit.distance;
        view.slant(v, u) = slant;
        view.measurable(v, u) = std::all_of(sensor_eyes.begin(), sensor_eyes.end(),
                                            [&](const Eigen::Vector3f& from) { return caster.visible(point, from); });
      }
      const Eigen::Vector3f& lamp_point = lamp_points[std::size_t((v % pattern) * pattern + u % pattern)];
      const Eigen::Vector3f to_lamp = (lighting.lamp.cast<float>() - point).normalized();
      const float lambert = std::max(0.f, hit.normal.dot(to_lamp));
      lit(v, u) = lambert > 0 && caster.visible(point, lamp_point) ? 1.f : 0.f;
      albedo(v, u) = bodies[std::size_t(hit.body)]->paint.of(hit.part).sample(hit.texture);
      lamp(v, u) = float(lighting.lamp_strength) * lambert;
      if (const float gloss = bodies[std::size_t(hit.body)]->paint.gloss; gloss > 0) {
        const Eigen::Vector3f halfway = (to_lamp - direction.normalized()).normalized();
        shine(v, u) = gloss * 255 * std::pow(std::max(0.f, hit.normal.dot(halfway)), sharpness);
      }
      // Light from above and the window reach everywhere, walls of hollows and undersides less.
      rest(v, u) = float(lighting.ambient) * (0.75f + 0.25f * hit.normal.z()) +
                   float(lighting.window_strength) * std::max(0.f, hit.normal.dot(lighting.window.cast<float>()));
    }

  const cv::Mat_<float> lamp_share = smooth_light(lit, surface, distance);
  for (int v = 0; v < camera.height; ++v)
    for (int u = 0; u < camera.width; ++u) {
      const double x = (u - camera.cx) / camera.fx, y = (v - camera.cy) / camera.fy;
      const auto vignette = float(1 / (1 + 0.6 * (x * x + y * y)));
      const float light = vignette * (lamp(v, u) * lamp_share(v, u) + rest(v, u));
      view.colour(v, u) = (light * albedo(v, u)).mul(lighting.tint) + cv::Vec3f::all(shine(v, u) * lamp_share(v, u));
    }
  return view;
}

}  // namespace gestalt::synthesis
