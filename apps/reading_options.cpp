// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reading_options.h"

#include <iostream>
#include <map>
#include <mutex>
#include <set>

#include "gestalt/io/scene/depth_unit.h"

namespace gestalt::app {

namespace {

const std::map<std::string, DepthKind> depth_kinds{
    {"plain", DepthKind::plain}, {"radial", DepthKind::radial}, {"rotated", DepthKind::rotated}};

/// "parts" is what --labels of convert called it first.
const std::map<std::string, LabelScheme> label_schemes{{"osd", LabelScheme::osd},
                                                       {"parts", LabelScheme::osd},
                                                       {"objects", LabelScheme::objects},
                                                       {"colours", LabelScheme::colours}};

template <class Value>
std::vector<std::string> names_of(const std::map<std::string, Value>& named) {
  std::vector<std::string> names;
  for (const auto& [name, value] : named) names.push_back(name);
  return names;
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
    return command.add_option(name, value, what)->check(CLI::Range(0.0, 1e7))->excludes(camera)->type_name("PX");
  };
  CLI::Option* fx =
      intrinsic("--fx", options.fx, "The same by numbers: focal length in pixel widths; the size is the images'");
  CLI::Option* fy = intrinsic("--fy", options.fy, "Focal length in pixel heights (default: that of --fx)");
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
  command.add_option("--depth-scale", options.depth_scale, "The same as a number: metres per unit")
      ->check(CLI::Range(1e-9, 1e4))
      ->excludes(unit)
      ->type_name("S");
  command
      .add_option_function<std::string>(
          "--depth-kind", [&](const std::string& name) { options.depth_kind = depth_kinds.at(name); },
          "What depth is: plain, along the optical axis (the default); radial, the distance from the camera; rotated, "
          "16 bits rotated by three as in SUN RGB-D")
      ->check(CLI::IsMember(names_of(depth_kinds)))
      ->type_name("KIND");
  command
      .add_option_function<std::string>(
          "--labels", [&](const std::string& name) { options.labels = label_schemes.at(name); },
          "What ground truth counts (default: guessed where that is certain): osd, 0 ignored, 1 to 9 background, 20 to "
          "29 the first object, ...; objects, 0 background, every other number an object; colours, the commonest is "
          "background")
      ->check(CLI::IsMember(names_of(label_schemes)))
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

Input read_and_warn(const std::filesystem::path& scene, const ReadOptions& options) {
  Input input = read_scene(scene, options);
  for (const std::string& warning : input.warnings) std::cerr << "gestalt: warning: " + warning + "\n";
  // A set of scenes has the same of each: the first tells it.
  static std::mutex in_use;
  static std::set<std::string> told;
  const std::lock_guard lock(in_use);
  for (const std::string& note : input.notes)
    if (told.insert(note).second) std::cerr << "gestalt: note: " + scene.string() + ": " + note + "\n";
  return input;
}

}  // namespace gestalt::app
