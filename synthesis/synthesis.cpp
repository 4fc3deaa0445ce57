// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/synthesis/synthesis.h"

#include <algorithm>
#include <cmath>

#include "gestalt/core/base/error.h"
#include "gestalt/core/base/suggest.h"
#include "ground_truth.h"
#include "kinect.h"
#include "layout.h"
#include "random.h"
#include "render.h"

namespace gestalt {

namespace {

using namespace synthesis;

bool every_thing_is_seen(const Measurement& measurement, std::size_t things, int smallest) {
  std::vector<int> pixels(things + 1, 0);
  for (const int body : measurement.body)
    if (body != IdealView::nothing) ++pixels[std::size_t(body)];
  return std::all_of(pixels.begin() + 1, pixels.end(), [&](int count) { return count >= smallest; });
}

}  // namespace

const std::vector<std::string>& category_names() {
  static const std::vector<std::string> names{"boxes",         "stacked_boxes", "occluded_objects", "cylindric_objects",
                                              "mixed_objects", "complex_scene"};
  return names;
}

const std::string& name_of(Category category) { return category_names()[std::size_t(category)]; }

Category category_of(std::string_view name) {
  const auto& names = category_names();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) {
    std::string known;
    for (const std::string& each : names) known += (known.empty() ? "" : ", ") + each;
    throw ConfigError("unknown category '" + std::string(name) + "'" + did_you_mean(name, names) + " (known: " + known +
                      ")");
  }
  return Category(found - names.begin());
}

Camera kinect_camera(int width, int height) {
  const double focal_length = 525.0 * width / 640;
  return {width, height, focal_length, focal_length, (width - 1) / 2.0, (height - 1) / 2.0};
}

int smallest_object(const Camera& camera) {
  return std::max(1, int(std::lround(300 * (camera.fx / 525) * (camera.fy / 525))));
}

SyntheticScene synthesize(Category category, std::uint64_t seed, int index, const Camera& camera) {
  const std::string name = name_of(category) + "_" + std::to_string(seed) + "_" +
                           (index < 10    ? "00"
                            : index < 100 ? "0"
                                          : "") +
                           std::to_string(index);
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
    const IdealView view = render(*arrangement);
    const Measurement measurement = measure_depth(view, camera, random);
    if (!every_thing_is_seen(measurement, arrangement->things.size(), smallest_object(camera))) continue;
    cv::Mat_<float> depth;
    measurement.depth.convertTo(depth, CV_32F, 1.0 / 1000);
    return {make_frame(name, measure_colour(view, random), depth, camera),
            label_parts(measurement.depth, measurement.body), name_of(category)};
  }
  refuse();
  return {};
}

}  // namespace gestalt
