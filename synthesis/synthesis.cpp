// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/synthesis/synthesis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

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

/// What a sensor gives of an arrangement; nothing where a thing shows less than `smallest` pixels.
std::optional<SyntheticScene> measure(const std::string& name, Category category, const Arrangement& arrangement,
                                      const Camera& camera, SensorModel sensor, Random& random, int smallest) {
  const IdealView view = render(arrangement, sensor);
  const Measurement measurement = measure_depth(sensor, view, camera, random);
  if (!every_thing_is_seen(measurement, arrangement.things.size(), smallest)) return std::nullopt;
  cv::Mat_<float> depth;
  measurement.depth.convertTo(depth, CV_32F, 1.0 / 1000);
  return SyntheticScene{make_frame(name, measure_colour(view, random), depth, camera),
                        label_parts(measurement.depth, measurement.body), name_of(category), objects_of(arrangement),
                        arrangement.viewpoint.pose};
}

/// A scene with what it shows, and the random numbers after it.
struct Arranged {
  Arrangement arrangement;
  Random random;
  SyntheticScene scene;
};

Arranged arrange(Category category, std::uint64_t seed, int index, const Camera& camera, SensorModel sensor) {
  const std::string name = scene_name(category, sensor, seed, index);
  const InputError refusal(name + ": the objects do not fit into the view of a camera of " +
                           std::to_string(camera.width) + "x" + std::to_string(camera.height) +
                           " pixels; use one that sees at least 50 x 40 degrees");
  constexpr double degrees = CV_PI / 180;
  if (!(camera.width > 2 * std::tan(25 * degrees) * camera.fx &&
        camera.height > 2 * std::tan(20 * degrees) * camera.fy))
    throw refusal;
  Random layouts = Random::of(seed, std::uint64_t(category) << 32 | std::uint32_t(index));
  constexpr int attempts = 60;
  for (int attempt = 0; attempt < attempts; ++attempt) {
    Random random(layouts.bits());
    auto arrangement = lay_out(category, camera, random);
    if (!arrangement) continue;
    if (auto scene = measure(name, category, *arrangement, camera, sensor, random, smallest_object(camera)))
      return {std::move(*arrangement), random, std::move(*scene)};
  }
  throw refusal;
}

/// Things on which hardly another one stands, at least one of them.
std::vector<std::size_t> highest_third(const std::vector<Body>& things) {
  std::vector<std::size_t> order(things.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto top = [&](std::size_t i) {
    double highest = -std::numeric_limits<double>::infinity();
    for (const Vertex& vertex : things[i].mesh.vertices)
      highest = std::max(highest, (things[i].pose * vertex.position.cast<double>()).z());
    return highest;
  };
  std::vector<double> tops;
  tops.reserve(order.size());
  for (const std::size_t i : order) tops.push_back(top(i));
  std::stable_sort(order.begin(), order.end(), [&](std::size_t x, std::size_t y) { return tops[x] > tops[y]; });
  order.resize(std::max<std::size_t>(1, things.size() / 3));
  return order;
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

// boxes_1_007, boxes_active_stereo_1_007.
std::string scene_name(Category category, SensorModel sensor, std::uint64_t seed, int index) {
  std::string number = std::to_string(index);
  if (number.size() < 3) number.insert(0, 3 - number.size(), '0');
  return name_of(category) +
         (sensor == SensorModel::structured_light ? "" : "_" + sensor_model_names()[std::size_t(sensor)]) + "_" +
         std::to_string(seed) + "_" + number;
}

SyntheticScene synthesize(Category category, std::uint64_t seed, int index, const Camera& camera, SensorModel sensor) {
  return arrange(category, seed, index, camera, sensor).scene;
}

std::vector<SyntheticScene> synthesize_sequence(Category category, std::uint64_t seed, int index, int frames,
                                                const Camera& camera, SensorModel sensor) {
  Arranged arranged = arrange(category, seed, index, camera, sensor);
  const std::vector<std::size_t> carried = highest_third(arranged.arrangement.things);
  std::vector<Eigen::Vector3d> ways;
  for (std::size_t i = 0; i < carried.size(); ++i) {
    const double direction = arranged.random.uniform(0, 2 * CV_PI);
    ways.emplace_back(0.12 * std::cos(direction), 0.12 * std::sin(direction), 0.1);
  }
  std::vector<SyntheticScene> sequence{std::move(arranged.scene)};
  while (int(sequence.size()) < frames) {
    const double time = double(sequence.size());
    Arrangement now = arranged.arrangement;
    const double swing = CV_PI / 18 * std::sin(2 * CV_PI * time / 60), way = (1 - std::cos(2 * CV_PI * time / 40)) / 2;
    now.viewpoint.pose = Eigen::AngleAxisd(swing, Eigen::Vector3d::UnitZ()) * now.viewpoint.pose;
    for (std::size_t i = 0; i < carried.size(); ++i) now.things[carried[i]].pose.pretranslate(way * ways[i]);
    sequence.push_back(measure("", category, now, camera, sensor, arranged.random, 0).value());
  }
  for (std::size_t i = 0; i < sequence.size(); ++i) {
    const std::string number = std::to_string(i);
    sequence[i].frame.name = std::string(std::max<std::size_t>(4, number.size()) - number.size(), '0') + number;
  }
  return sequence;
}

}  // namespace gestalt
