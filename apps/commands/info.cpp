// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <opencv2/core.hpp>

#include "command.h"
#include "gestalt/apps/frame_options.h"
#include "gestalt/apps/input_picture.h"
#include "gestalt/apps/output_check.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/file_bytes.h"
#include "gestalt/core/base/json_file.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/io/bag/bag.h"
#include "gestalt/io/result/result_digests.h"
#include "gestalt/io/result/result_file.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_format.h"
#include "gestalt/io/scene/scene_path.h"
#include "gestalt/io/scene/yaml_document.h"

namespace gestalt::app::info_command {

namespace fs = std::filesystem;
using Description = nlohmann::ordered_json;

namespace {

constexpr std::uintmax_t largest_yaml = 1 << 20;  // bytes

/// To six decimals: depth is stored in single precision, more would be noise.
double rounded(double value) { return std::round(value * 1e6) / 1e6; }

Description describe_camera(const Camera& c) {
  return {{"width", c.width}, {"height", c.height}, {"fx", c.fx}, {"fy", c.fy}, {"cx", c.cx}, {"cy", c.cy}};
}

Description describe_labels(const cv::Mat_<std::uint16_t>& labels) {
  std::map<int, int> pixels;
  for (const std::uint16_t label : labels) ++pixels[label];
  std::map<int, int> objects;
  Description values;
  for (const auto& [label, count] : pixels) {
    objects[object_of_label(label)] += count;
    values[std::to_string(label)] = count;
  }
  return {{"objects", std::count_if(objects.begin(), objects.end(), [](const auto& o) { return o.first > 1; })},
          {"background_pixels", objects[1]},
          {"ignored_pixels", objects[0]},
          {"pixels_of_label", values}};
}

/// What a scene holds, once it is read.
void add_scene(Description& description, const Input& input, const std::string& camera_source) {
  const Frame& frame = input.frame;
  const cv::Mat measured = frame.depth > 0;
  double nearest = 0, farthest = 0;
  cv::minMaxLoc(frame.depth, &nearest, &farthest, nullptr, nullptr, measured);
  description["name"] = frame.name;
  description["width"] = frame.width();
  description["height"] = frame.height();
  description["colour"] = frame.has_colour();
  if (!input.colour_from.empty()) description["colour_from"] = input.colour_from;
  description["valid_pixels"] = cv::countNonZero(measured);
  description["valid_share"] = rounded(double(cv::countNonZero(measured)) / double(frame.depth.total()));
  description["depth_range_m"] = {rounded(nearest), rounded(farthest)};
  description["depth_unit"] = input.depth_unit;
  if (!input.warnings.empty()) description["warnings"] = input.warnings;
  if (!input.notes.empty()) description["notes"] = input.notes;
  if (!input.point_pixels.empty())
    description["points_outside_image"] = std::count(input.point_pixels.begin(), input.point_pixels.end(), -1);
  if (!input.ground_truth_problem.empty()) description["labels_problem"] = input.ground_truth_problem;
  if (!input.ground_truth.empty()) description["labels"] = describe_labels(input.ground_truth);
  description["camera"] = describe_camera(frame.camera);
  description["camera_from"] = input.camera_from.empty() ? camera_source : input.camera_from;
}

std::string camera_source(const SceneFormat& format, const fs::path& scene, const ReadOptions& options) {
  if (options.camera) return options.camera->file.empty() ? "the numbers given" : options.camera->file.string();
  if (format.camera == CameraPlace::scene) return "the file, or a camera.yaml";
  const auto found = find_camera_file(scene);
  return found ? found->string() : "fitted to the points";
}

struct Options {
  ReadOptions read;
  fs::path picture;  ///< to draw what was read into; empty: none
};

Description describe_scene(const SceneFormat& format, const fs::path& scene, const Options& options) {
  Description description{{"kind", format.kind}};
  if (format.facts) description.update(format.facts(scene, options.read));
  if (description.contains("camera_from")) return description;
  const Input input = read_and_warn(scene, options.read);
  add_scene(description, input, camera_source(format, scene, options.read));
  if (!options.picture.empty()) {
    require_of_no_scene("--picture", options.picture, {scene});
    write_files({{options.picture, input_picture(input.frame)}});
    description["picture"] = options.picture.string();
  }
  return description;
}

Description describe_folder(const fs::path& folder, const Options& options) {
  const auto scenes = find_scenes({folder});
  Description names = Description::array();
  for (const fs::path& scene : scenes) names.push_back(scene_name(scene));
  const bool recording = !is_scene(scenes.front());
  Description description{
      {"kind", recording ? "recording" : "folder of scenes"}, {"count", scenes.size()}, {"scenes", names}};
  // Its frames are of one camera and unit.
  if (recording) description["first"] = describe_scene(*scene_format_of(scenes.front()), scenes.front(), options);
  return description;
}

Description describe_model(const nlohmann::json& model) {
  Description description{{"kind", "model"}};
  for (const auto& [name, level] : model.at("levels").items()) {
    const nlohmann::json& training = level.at("training");
    description[name] = {{"classifier", level.at("classifier")},
                         {"values", level.at("names")},
                         {"training_minima", level.at("scaling").at("low")},
                         {"training_maxima", level.at("scaling").at("high")},
                         {"positive_pairs", training.at("positive_pairs")},
                         {"negative_pairs", training.at("negative_pairs")},
                         {"training_scenes", training.at("scenes")},
                         {"config_hash", level.at("config_hash")}};
  }
  return description;
}

Description describe_result(const fs::path& file) {
  const nlohmann::json result = read_result_content(file);
  Description description{{"kind", "result of gestalt segment"}};
  for (const char* list : {"segments", "patches", "pairs"}) description[list] = result.at(list).size();
  for (const char* fact : {"scene", "camera", "milliseconds", "gestalt", "build"}) description[fact] = result.at(fact);
  if (const std::string warning = warning_of_foreign_files(file, result); !warning.empty()) {
    std::cerr << "gestalt: warning: " << warning << '\n';
    description["foreign_files"] = foreign_files(file, result);
  }
  return description;
}

Description describe_bag(const fs::path& file) {
  const std::unique_ptr<Bag> bag = open_bag(file, [](const BagTopic&, const MessagePlace&, std::string_view) {});
  Description topics = Description::object();
  for (const BagTopic& topic : bag->topics())
    topics[topic.name] = (topic.type.empty() ? "unknown type" : topic.type) + ", " + std::to_string(topic.messages) +
                         (topic.messages == 1 ? " message" : " messages");
  Description description{{"kind", "recording of ROS"}, {"topics", std::move(topics)}};
  if (!bag->broken_off().empty()) description["breaks_off"] = bag->broken_off();
  description["more"] = "gestalt convert " + file.string() + " --output scenes";
  return description;
}

[[noreturn]] void fail(const fs::path& file, const std::string& why) {
  throw InputError(file.string() + ": " + why + "; info reads scene folders, " + scene_extensions(" and ") +
                   " files, recordings of ROS, camera files, configs, models and result.json");
}

Description describe_camera_file(const fs::path& file) {
  const CameraFile camera = read_camera(file);
  Description description{{"kind", "camera file"}};
  description.update(describe_camera(camera.camera));
  if (camera.camera.width == 0) description["width"] = description["height"] = "of the images";
  if (camera.depth_scale) description["depth_scale"] = *camera.depth_scale;
  if (camera.lens.distorts()) description["distortion"] = camera.lens.coefficients;
  if (!camera.notes.empty()) description["notes"] = camera.notes;
  return description;
}

Description describe_json(const fs::path& file) try {
  const nlohmann::json content = read_json(file);
  const std::string format = content.is_object() ? content.value("format", "") : "";
  if (format == "gestalt-model") return describe_model(content);
  if (format == "gestalt-result") return describe_result(file);
  return describe_camera_file(file);
} catch (const nlohmann::json::exception& error) {
  const std::string what = error.what();  // [json.exception.KIND.NUMBER] WHAT
  fail(file,
       "is not a complete model or result: " + what.substr(what.find("] ") == what.npos ? 0 : what.find("] ") + 2));
}

Description describe_yaml(const fs::path& file) {
  YAML::Node content;
  try {
    content = load_yaml_document(read_bytes(file, largest_yaml));
  } catch (const YAML::Exception& error) {
    fail(file, std::string("is not valid YAML: ") + error.what());
  }
  if (content.IsMap() && (content["schema_version"] || content["extends"])) {
    Description sections = Description::array();
    for (const auto& entry : content) sections.push_back(entry.first.Scalar());
    Description description{{"kind", "config"}, {"keys", sections}};
    for (const char* key : {"schema_version", "extends"})
      if (content[key] && content[key].IsScalar()) description[key] = content[key].Scalar();
    description["more"] = "gestalt config print " + file.string();
    return description;
  }
  return describe_camera_file(file);
}

Description describe(const fs::path& path, const Options& options) {
  std::error_code error;
  const auto status = fs::status(path, error);
  if (status.type() == fs::file_type::not_found) fail(path, "does not exist");
  const SceneFormat* const format = scene_format_of(path);
  if (status.type() == fs::file_type::directory && !format && is_bag(path)) return describe_bag(path);
  if (status.type() == fs::file_type::directory)
    return format ? describe_scene(*format, path, options) : describe_folder(path, options);
  if (status.type() != fs::file_type::regular) fail(path, "is neither a file nor a folder");
  if (!std::ifstream(path)) fail(path, "cannot be read");
  if (format) return describe_scene(*format, path, options);
  if (is_bag(path)) return describe_bag(path);
  const std::string extension = lower_extension(path);
  if (extension == ".json") return describe_json(path);
  if (extension == ".yaml" || extension == ".yml") return describe_yaml(path);
  for (const char* of_cameras : {".xml", ".txt", ".intr", ".pincam", ".csv"})
    if (extension == of_cameras) return describe_camera_file(path);
  fail(path, "is of an unknown kind");
}

std::string one_line(const Description& value) {
  if (value.is_string()) return value.get<std::string>();
  if (!value.is_array()) return value.dump();
  std::string text;
  for (const Description& item : value) text += (text.empty() ? "" : ", ") + one_line(item);
  return text;
}

void print(const Description& description, const std::string& indent) {
  for (const auto& [key, value] : description.items()) {
    std::cout << indent << key << ':' << (value.is_object() ? "" : " " + one_line(value)) << '\n';
    if (value.is_object()) print(value, indent + "  ");
  }
}

/// The name of a picture that is written as PNG. Returns what is wrong with it, as CLI11 wants.
std::string png_name(const std::string& file) {
  if (lower_extension(file) == ".png") return "";
  return file + ": the picture is written as PNG; give a name that ends in .png";
}

void add_info(CLI::App& app, Run& run) {
  struct Arguments {
    std::vector<fs::path> files;
    FrameOptions frame;
    ReadingOptions reading;
    fs::path picture;
    bool json = false;
  };
  const auto arguments = std::make_shared<Arguments>();
  CLI::App* command = app.add_subcommand("info", "Describe a scene, cloud, camera, config, model or result file");
  command->add_option("FILE", arguments->files,
                      "Scene folder, folder of scenes, recording, " + scene_extensions(", ") +
                          ", depth image with or without its colour image, recording of ROS, YAML or JSON file");
  add_frame_options(*command, arguments->frame);
  add_reading_options(*command, arguments->reading);
  command
      ->add_option("--picture", arguments->picture,
                   "Draw the input as a PNG file: colour beside colour-mapped depth (first frame of a recording)")
      ->type_name("FILE")
      ->check(png_name);
  command->add_flag("--json", arguments->json, "Print JSON");
  command->footer("Example: gestalt info examples/demo_scene");
  command->callback([arguments, &run] {
    require_input_or_frame(arguments->files, arguments->frame);
    run = [arguments] {
      const std::vector<fs::path> files = inputs_with_frame(arguments->files, arguments->frame);
      if (files.size() > 1) fail(files[1], "is a second input; give one, or a depth image with its colour image");
      arguments->reading.colour = arguments->frame.colour;
      const Description description = describe(files.front(), {read_options(arguments->reading), arguments->picture});
      if (arguments->json)
        std::cout << description.dump(2, ' ', false, Description::error_handler_t::replace) << '\n';
      else
        print(description, "");
      return success;
    };
  });
}

const Subcommand subcommand(140, add_info);

}  // namespace

}  // namespace gestalt::app::info_command
