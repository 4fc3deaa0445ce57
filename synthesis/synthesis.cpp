// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/synthesis/synthesis.h"

#include <algorithm>
#include <cmath>

#include "colour_camera.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/suggest.h"
#include "ground_truth.h"
#include "layout.h"
#include "random.h"
#include "render.h"
#include "sensor.h"

namespace gestalt {

namespace {

using namespace synthesis;

bool every_thing_is_seen(const Measurement& measurement, std::size_t things, int smallest) {
  std::vector<int> pixels(things + 1, 0);
  for (const int body : measurement.body)
    if (body > 0) ++pixels[std::size_t(body)];
  return std::all_of(pixels.begin() + 1, pixels.end(), [&](int count) { return count >= smallest; });
}

std::vector<SyntheticObject> objects_of(const Arrangement& arrangement) {
  std::vector<SyntheticObject> objects;
  for (const Body& body : arrangement.things) {
    const Eigen::Isometry3d from_middle(Eigen::Translation3d(0, 0, body.size.z() / 2));
    objects.push_back({body.shape, body.size, arrangement.viewpoint.pose.inverse() * body.pose * from_middle});
  }
  return objects;
}

/// Throws ConfigError where the name is not among the names.
std::size_t place_in(const std::vector<std::string>& names, std::string_view name, const std::string& what) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string known;
    for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
    throw ConfigError("unknown " + what + " '" + std::string(name) + "'" + did_you_mean(name, names) +
                      " (known: " + known + ")");
  }
  return std::size_t(found - names.begin());
}

/// boxes_1_007, boxes_active_stereo_1_007.
std::string scene_name(Category category, SensorModel sensor, std::uint64_t seed, int index) {
  std::string number = std::to_string(index);
  if (number.size() < 3) number.insert(0, 3 - number.size(), '0');
  return name_of(category) +
         (sensor == SensorModel::structured_light ? "" : "_" + sensor_model_names()[std::size_t(sensor)]) + "_" +
         std::to_string(seed) + "_" + number;
}

}  // namespace

const std::vector<std::string>& category_names() {
  static const std::vector<std::string> names{"boxes",
                                              "stacked_boxes",
                                              "occluded_objects",
                                              "cylindric_objects",
                                              "mixed_objects",
                                              "complex_scene",
                                              "packages",
                                              "groceries",
                                              "bin",
                                              "thin_and_small",
                                              "shelf"};
  return names;
}

const std::string& name_of(Category category) { return category_names()[std::size_t(category)]; }

Category category_of(std::string_view name) { return Category(place_in(category_names(), name, "category")); }

const std::vector<std::string>& sensor_model_names() {
  static const std::vector<std::string> names{"structured_light", "active_stereo", "time_of_flight"};
  return names;
}

SensorModel sensor_model_of(std::string_view name) {
  return SensorModel(place_in(sensor_model_names(), name, "sensor"));
}

Camera kinect_camera(int width, int height) {
  const double focal_length = 525.0 * width / 640;
  return {width, height, focal_length, focal_length, (width - 1) / 2.0, (height - 1) / 2.0};
}

int smallest_object(const Camera& camera) {
  return std::max(1, int(std::lround(300 * (camera.fx / 525) * (camera.fy / 525))));
}

SyntheticScene synthesize(Category category, std::uint64_t seed, int index, const Camera& camera, SensorModel sensor) {
  const std::string name = scene_name(category, sensor, seed, index);
  const auto refuse = [&] {
    throw InputError(name + ": the objects do not fit into the view of a camera of " + std::to_string(camera.width) +
                     "x" + std::to_string(camera.height) + " pixels; use one that sees at least 50 x 40 degrees");
  };
  constexpr double degrees = CV_PI / 180;
  if (!(camera.width > 2 * std::tan(25 * degrees) * camera.fx &&
        camera.height > 2 * std::tan(20 * degrees) * camera.fy))
    refuse();
  Random layouts = Random::of(seed, std::uint64_t(category) << 32 | std::uint32_t(index));
  constexpr int attempts = 60;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Random random(layouts.bits());
    const auto arrangement = lay_out(category, camera, random);
    if (!arrangement) continue;
    const IdealView view = render(*arrangement, sensor);
    const Measurement measurement = measure_depth(sensor, view, camera, random);
    if (!every_thing_is_seen(measurement, arrangement->things.size(), smallest_object(camera))) continue;
    cv::Mat_<float> depth;
    measurement.depth.convertTo(depth, CV_32F, 1.0 / 1000);
    return {make_frame(name, measure_colour(view, random), depth, camera),
            label_parts(measurement.depth, measurement.body), name_of(category), objects_of(*arrangement)};
  }
  refuse();
  return {};
}

}  // namespace gestalt
