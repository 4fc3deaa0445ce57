// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <iostream>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "command.h"
#include "gestalt/apps/reading_options.h"
#include "gestalt/apps/scene_batch.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/output_file.h"
#include "gestalt/io/bag/bag_frames.h"
#include "gestalt/io/dataset/bop_scene.h"
#include "gestalt/io/dataset/labelled_cloud.h"
#include "gestalt/io/dataset/ocid_sequence.h"
#include "gestalt/io/dataset/osd_release.h"
#include "gestalt/io/dataset/tum_sequence.h"
#include "gestalt/io/scene/scene_format.h"
#include "gestalt/io/scene/scene_names.h"

namespace gestalt::app::convert_command {

namespace {

namespace fs = std::filesystem;

struct Options {
  fs::path input;
  std::string from;          ///< empty: guessed
  std::string to = "scene";  ///< one of scene_formats()
  fs::path output;
  ReadingOptions reading;
  BagTopics topics;
};

/// A scene of any layout. It goes by the path that names it in messages.
struct SourceScene {
  fs::path path;
  std::string name;
  std::function<ConvertedScene()> read;
};

std::vector<SourceScene> osd_scenes(const Options& options, const ReadOptions& read) {
  std::vector<SourceScene> scenes;
  for (const std::string& name : find_osd_scenes(options.input))
    scenes.push_back({options.input / "disparity" / (name + ".png"), name,
                      [=, release = options.input] { return read_osd_scene(release, name, read); }});
  return scenes;
}

std::vector<SourceScene> tum_scenes(const Options& options, const ReadOptions& read) {
  std::vector<SourceScene> scenes;
  for (const FrameFiles& frame : find_tum_frames(options.input))
    scenes.push_back({frame.depth, frame.depth.stem().string(), [=] { return read_tum_frame(frame, read); }});
  return scenes;
}

std::vector<SourceScene> bop_scenes(const Options& options, const ReadOptions& read) {
  std::vector<SourceScene> scenes;
  for (const BopImage& image : find_bop_images(options.input))
    scenes.push_back({image.depth, bop_name(image), [=] { return read_bop_image(image, read); }});
  return scenes;
}

std::vector<SourceScene> ocid_scenes(const Options& options, const ReadOptions& read) {
  std::vector<SourceScene> scenes;
  for (const OcidFrame& frame : find_ocid_frames(options.input))
    scenes.push_back({frame.depth, frame.name, [=] { return read_ocid_frame(frame, read); }});
  return scenes;
}

std::vector<SourceScene> bag_scenes(const Options& options, const ReadOptions& read) {
  const auto bag = std::make_shared<const BagFrames>(options.input, options.topics);
  tell(options.input, bag->warnings(), bag->notes());
  std::vector<SourceScene> scenes;
  for (const BagFrame& frame : bag->frames())
    scenes.push_back({options.input / frame.name, frame.name, [=] { return bag->read(frame, read); }});
  return scenes;
}

/// Scenes of one of scene_formats().
std::vector<SourceScene> own_scenes(const Options& options, const ReadOptions& read) {
  std::vector<SourceScene> scenes;
  for (const fs::path& path : find_scenes({options.input})) {
    const SceneFormat* const format = scene_format_of(path);
    const std::string kind = format ? format->name : "";
    if (!format) read_scene(path);  // throws with the reason
    if (kind != options.from)
      throw InputError(path.string() + ": is " + (kind == "scene" ? "already a scene folder" : "not " + options.from) +
                       "; give only inputs of the layout that --from names");
    const bool labelled = options.from == "pcd";
    scenes.push_back({path, scene_name(path),
                      [=] { return labelled ? read_labelled_cloud(path, read) : converted(read_scene(path, read)); }});
  }
  return scenes;
}

/// How a data set is laid out.
struct Layout {
  std::string name;
  std::vector<std::string> holds;  ///< by which a folder is recognised; none: it is a file
  std::string input;               ///< what the command takes, for its help
  std::string summary;
  std::vector<SourceScene> (*scenes)(const Options& options, const ReadOptions& read);
};

const std::vector<Layout> layouts{
    {"osd",
     {"disparity", "annotation"},
     "the folder with image_color, disparity and annotation",
     "the original release of the Object Segmentation Database",
     osd_scenes},
    {"tum", {"rgb.txt", "depth.txt"}, "a sequence", "an RGB-D sequence of TUM", tum_scenes},
    {"bop", {"scene_camera.json"}, "a scene or a folder of them", "of the BOP benchmark", bop_scenes},
    {"ocid", {"depth", "label"}, "the release or a part of it", "the Object Cluttered Indoor Dataset", ocid_scenes},
    {"rosbag", {}, "a .bag, .mcap or .db3 file, or the folder of rosbag2", "a recording of ROS 1 or 2", bag_scenes}};

/// The layout that the input has by its files.
std::string guess(const fs::path& input) {
  std::error_code error;
  const auto is_there = [&](const std::string& name) { return fs::exists(input / name, error); };
  if (is_bag(input)) return "rosbag";
  for (const Layout& layout : layouts)
    if (!layout.holds.empty() && std::ranges::all_of(layout.holds, is_there)) return layout.name;
  if (const SceneFormat* format = scene_format_of(input)) return format->name;
  try {
    for (const fs::path& scene : find_scenes({input}))  // a link to nowhere has no format
      if (const SceneFormat* format = scene_format_of(scene)) return format->name;
  } catch (const InputError&) {  // of which the layout that is asked for tells
  }
  throw InputError(input.string() + ": cannot tell its layout from its files; give --from");
}

std::vector<SourceScene> open(const Options& options) {
  const ReadOptions read = read_options(options.reading);
  const auto layout = std::ranges::find(layouts, options.from, &Layout::name);
  if (layout != layouts.end() && read.labels != LabelScheme::guess)
    throw ConfigError("--labels: the annotation of --from " + options.from + " has a fixed meaning; omit this option");
  if (options.from != "rosbag" && !(options.topics.depth.empty() && options.topics.colour.empty()))
    throw ConfigError("--depth-topic and --rgb-topic are of recordings of ROS; omit them for --from " + options.from);
  return (layout == layouts.end() ? own_scenes : layout->scenes)(options, read);
}

/// Where the scene is then.
fs::path write(const Options& options, const std::string& set, const std::string& name, const ConvertedScene& scene) {
  const OutputPath folder = OutputPath(options.output) / set, place = folder / name;
  const SceneFormat& format = *find_scene_format(options.to);
  if (!format.encode) {
    write_scene_folder(place, scene.images, scene.camera, scene.depth_scale);
    return place.path();
  }
  const OutputPath file = folder / (name + format.extension);
  write_files({{file, format.encode(scene)}});
  if (format.camera == CameraPlace::camera_file) write_camera(scene.camera, folder);
  return file.path();
}

int convert(Options options) {
  if (options.from.empty()) options.from = guess(options.input);
  if (options.from == options.to) throw InputError(options.input.string() + ": already has the layout of --to");
  const std::vector<SourceScene> scenes = open(options);
  std::vector<NamedScene> named;
  for (const SourceScene& scene : scenes) named.push_back({scene.path, scene.name});
  check_scene_names(named);
  std::map<fs::path, const SourceScene*> by_path;
  std::vector<fs::path> paths;
  for (const SourceScene& scene : scenes) {
    paths.push_back(scene.path);
    by_path[scene.path] = &scene;
  }
  std::map<std::string, std::map<std::string, std::string>> categories;  // of the scenes of each set
  std::mutex categories_in_use;
  const int code = for_each_scene(paths, [&](const fs::path& path) {
    const SourceScene& source = *by_path.at(path);
    const ConvertedScene scene = source.read();
    tell(path, scene.warnings, scene.notes);
    const auto [set, category] = osd_scene(source.name);
    const fs::path place = write(options, set, source.name, scene);
    if (!category.empty()) {
      const std::lock_guard lock(categories_in_use);
      categories[set][source.name] = category;
    }
    return place.string() + (scene.images.label.empty() ? "" : ": " + std::to_string(scene.objects) + " objects") +
           (category.empty() ? "" : ", " + category);
  });
  for (const auto& [set, of_scenes] : categories)
    merge_categories(OutputPath(options.output) / (set + ".csv"), of_scenes);
  return code;
}

void add_convert(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("convert", "Convert data sets to scenes, and scenes to files");
  std::vector<std::string> sources, targets;
  std::string inputs, read, written;
  for (const Layout& layout : layouts) {
    sources.push_back(layout.name);
    inputs += layout.name + ": " + layout.input + ". ";
    read += (read.empty() ? "" : "; ") + layout.name + ", " + layout.summary;
  }
  command->add_option("input", options->input, inputs + "Else a file or scene, or a folder of those")
      ->required()
      ->type_name("INPUT");
  for (const SceneFormat& format : scene_formats()) {
    sources.push_back(format.name);
    read += "; " + format.name + ", " + format.summary;
    if (!format.encode && format.name != options->to) continue;
    targets.push_back(format.name);
    written += (written.empty() ? "" : "; ") + format.name + ", " + format.summary;
  }
  command->add_option("--from", options->from, "Layout of the input (default: by its files): " + read)
      ->check(CLI::IsMember(sources));
  command->add_option("--to", options->to, "What to write: " + written)
      ->check(CLI::IsMember(targets))
      ->capture_default_str();
  command
      ->add_option("--output", options->output,
                   "Folder for learn/<scene>/{rgb,depth,label}.png and camera.yaml, learn.csv with the categories, and "
                   "the same for test; scenes whose name is neither learnN nor testN go to scenes/")
      ->required()
      ->type_name("DIR");
  command
      ->add_option("--depth-topic", options->topics.depth,
                   "Depth images of a recording of ROS (default: by the topics' names; `gestalt info` lists them)")
      ->type_name("TOPIC");
  command->add_option("--rgb-topic", options->topics.colour, "Its colour images")->type_name("TOPIC");
  add_reading_options(*command, options->reading);
  command->footer(
      "Example: gestalt convert OSD-0.2-depth --output osd\n"
      "         gestalt reproduce osd --output report\n"
      "         gestalt convert rgbd_dataset_freiburg1_desk --from tum --output desk\n"
      "         gestalt convert recording.bag --output recorded\n"
      "         gestalt convert scenes --from scene --to npz --output arrays");
  command->callback([options, &run] { run = [options] { return convert(*options); }; });
}

const Subcommand subcommand(80, add_convert);

}  // namespace

}  // namespace gestalt::app::convert_command
