// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reading_options.h"

#include <algorithm>
#include <iostream>
#include <map>
#include <mutex>
#include <set>

#include "gestalt/apps/number_in.h"
#include "gestalt/io/scene/depth_unit.h"
#include "gestalt/io/scene/reading_names.h"

namespace gestalt::app {

namespace {

/// An option that takes the name of a value.
template <class Named, class Value>
CLI::Option* add_named(CLI::App& command, const std::string& option, const Named& named, Value& value,
                       const std::string& what) {
  std::map<std::string, Value> values;
  std::vector<std::string> names;
  for (const auto& [name, named_value] : named) {
    values.emplace(name, named_value);
    names.emplace_back(name);
  }
  std::sort(names.begin(), names.end());
  return command
      .add_option_function<std::string>(
          option, [&value, values](const std::string& name) { value = values.at(name); }, what)
      ->check(CLI::IsMember(names));
}

const CLI::Validator is_unit(
    [](std::string& text) {
      return metres_of_unit(text) ? std::string()
                                  : "'" + text + "' is not a unit of length; write m, cm, mm, 0.1mm, ...";
    },
    "", "unit");

}  // namespace

void add_reading_options(CLI::App& command, ReadingOptions& options) {
  CLI::Option* camera =
      command
          .add_option("--camera", options.camera,
                      "Intrinsics to use instead of the scene's own: camera.yaml, or a file of ROS, OpenCV, Open3D, "
                      "RealSense, COLMAP, kalibr, ORB-SLAM, ARKit, a 3x3 matrix, ...")
          ->type_name("FILE");
  const auto intrinsic = [&](const char* name, std::optional<double>& value, const char* what) {
    return command.add_option(name, value, what)->check(number_in(0.0, 1e7))->excludes(camera)->type_name("PX");
  };
  CLI::Option* fx = intrinsic("--fx", options.fx,
                              "Horizontal focal length in pixels, instead of --camera; the size is that of the images");
  CLI::Option* fy = intrinsic("--fy", options.fy, "Vertical focal length in pixels (default: that of --fx)");
  CLI::Option* cx = intrinsic("--cx", options.cx, "Column of the principal point");
  CLI::Option* cy = intrinsic("--cy", options.cy, "Row of the principal point");
  fx->needs(cx)->needs(cy);
  fy->needs(fx);
  cx->needs(fx);
  cy->needs(fx);
  CLI::Option* unit = command
                          .add_option_function<std::string>(
                              "--unit", [&](const std::string& text) { options.depth_scale = metres_of_unit(text); },
                              "Unit of the depth, or of a cloud's points: m, cm, mm, 0.1mm, ... (default: what the "
                              "files tell; else mm for whole numbers, m for floats and clouds)")
                          ->check(is_unit)
                          ->type_name("UNIT");
  command.add_option("--depth-scale", options.depth_scale, "The same as a number, metres per unit")
      ->check(number_in(1e-9, 1e4))
      ->excludes(unit)
      ->type_name("S");
  add_named(
      command, "--depth-kind", depth_kinds, options.depth_kind,
      "Meaning of depth: plain, along the optical axis (the default); radial, the distance from the camera; rotated, "
      "16 bits rotated by three as in SUN RGB-D")
      ->type_name("KIND");
  add_named(command, "--labels", label_schemes, options.labels,
            "Meaning of the ground truth's numbers (default: guessed where that is certain): osd, 0 ignored, 1 to 9 "
            "background, 20 "
            "to 29 the first object, ...; objects, 0 background, every other number an object; colours, the commonest "
            "is background")
      ->type_name("SCHEME");
}

ReadOptions read_options(const ReadingOptions& options) {
  ReadOptions read;
  if (!options.camera.empty()) read.camera = read_camera(options.camera);
  if (options.fx)
    read.camera =
        Camera{0, 0, *options.fx, options.fy.value_or(*options.fx), options.cx.value_or(0), options.cy.value_or(0)};
  read.depth_scale = options.depth_scale;
  read.depth_kind = options.depth_kind;
  read.labels = options.labels;
  read.colour = options.colour;
  return read;
}

std::string text_of(const ReadingOptions& options) {
  std::string camera;
  for (const auto& number : {options.fx, options.fy, options.cx, options.cy})
    camera += (number ? std::to_string(*number) : "") + ' ';
  return camera + (options.depth_scale ? std::to_string(*options.depth_scale * 1e9) : "") + ' ' +
         std::to_string(int(options.depth_kind)) + ' ' + options.colour.string();
}

void tell(const std::filesystem::path& scene, const std::vector<std::string>& warnings,
          const std::vector<std::string>& notes) {
  for (const std::string& warning : warnings) std::cerr << "gestalt: warning: " + warning + "\n";
  // A set of scenes has the same of each: the first tells it.
  static std::mutex in_use;
  static std::set<std::string> told;
  const std::lock_guard lock(in_use);
  for (const std::string& note : notes)
    if (told.insert(note).second) std::cerr << "gestalt: note: " + scene.string() + ": " + note + "\n";
}

Input read_and_warn(const std::filesystem::path& scene, const ReadOptions& options) {
  Input input = read_scene(scene, options);
  tell(scene, input.warnings, input.notes);
  return input;
}

}  // namespace gestalt::app
