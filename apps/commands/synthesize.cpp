// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <filesystem>
#include <iostream>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "command.h"
#include "gestalt/apps/number_in.h"
#include "gestalt/apps/pipeline_options.h"
#include "gestalt/core/base/error.h"
#include "gestalt/core/base/for_all.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/io/scene/scene_folder.h"
#include "gestalt/synthesis/synthesis.h"

namespace gestalt::app::synthesize_command {

namespace {

struct SynthesizeOptions {
  std::string category;
  std::uint64_t seed = 1;
  int count = 1;
  int frames = 0;  ///< of each sequence; 0: scenes
  std::filesystem::path output;
  int width = 640;
  int height = 480;
  double focal_length = 0;
  std::string camera;
  std::string sensor = "structured_light";
  int threads = 0;
};

/// The camera of the file; else a Kinect's of this size, with the focal length where one is given.
Camera camera_of(const SynthesizeOptions& options) {
  if (!options.camera.empty()) {
    const CameraFile file = read_camera(options.camera);
    if (file.camera.width == 0 || file.lens.distorts())
      throw InputError(options.camera + ": " +
                       (file.camera.width == 0 ? "has no width and height" : "has a lens that distorts") +
                       "; scenes are made for a pinhole camera of a known size");
    return file.camera;
  }
  Camera camera = kinect_camera(options.width, options.height);
  if (options.focal_length > 0) camera.fx = camera.fy = options.focal_length;
  return camera;
}

/// scenes -> scenes.csv beside it.
std::filesystem::path categories_file(const std::filesystem::path& folder) {
  const std::filesystem::path name = folder.has_filename() ? folder : folder.parent_path();
  return name.string() + ".csv";
}

std::string known_names(const std::vector<std::string>& names) {
  std::string known;
  for (const std::string& name : names) known += (known.empty() ? "" : ", ") + name;
  return known;
}

/// Each in a folder of its own below the output's.
int synthesize_sequences(const SynthesizeOptions& options) {
  const ThreadLimit thread_limit(options.threads);
  const Category category = category_of(options.category);
  const SensorModel sensor = sensor_model_of(options.sensor);
  const Camera camera = camera_of(options);
  const std::filesystem::path folder = std::filesystem::absolute(options.output).lexically_normal();
  std::vector<std::string> names(std::size_t(options.count));
  for_all(names.size(), [&](std::size_t i) {
    names[i] = scene_name(category, sensor, options.seed, int(i));
    const std::vector<SyntheticScene> frames =
        synthesize_sequence(category, options.seed, int(i), options.frames, camera, sensor);
    write_camera(camera, folder / names[i]);
    write_sequence(frames, folder / names[i]);
  });
  for (const std::string& name : names) std::cout << (options.output / name).string() << '\n';
  return success;
}

int synthesize_scenes(const SynthesizeOptions& options) {
  const ThreadLimit thread_limit(options.threads);
  const Category category = category_of(options.category);
  const SensorModel sensor = sensor_model_of(options.sensor);
  const Camera camera = camera_of(options);
  const std::filesystem::path folder = std::filesystem::absolute(options.output).lexically_normal();
  // Before anything is written: a camera whose view is refused leaves nothing behind.
  const SyntheticScene first = synthesize(category, options.seed, 0, camera, sensor);
  write_camera(camera, folder);

  std::vector<std::string> names(std::size_t(options.count));
  for_all(names.size(), [&](std::size_t i) {
    const SyntheticScene scene = i == 0 ? first : synthesize(category, options.seed, int(i), camera, sensor);
    write_scene(scene, folder);
    names[i] = scene.frame.name;
  });

  std::map<std::string, std::string> categories;
  for (const std::string& name : names) categories[name] = options.category;
  merge_categories(categories_file(folder), categories);
  for (const std::string& name : names) std::cout << (options.output / name).string() << '\n';
  return success;
}

void add_synthesize(CLI::App& app, Run& run) {
  CLI::App& command = *app.add_subcommand(
      "synthesize", "Make labelled scenes of things on tables, in bins and on shelves, as a depth sensor sees them");
  auto options = std::make_shared<SynthesizeOptions>();
  command.footer("Example: gestalt synthesize --category complex_scene --seed 1 --count 5 --output scenes");
  command.add_option("--category", options->category, "One of " + known_names(category_names()))->required();
  command.add_option("--seed", options->seed, "The same seed gives the same scenes")
      ->check(seed_number())
      ->capture_default_str();
  command.add_option("--count", options->count, "Scenes to make")->check(number_in(1, 100000))->capture_default_str();
  command
      .add_option("--frames", options->frames,
                  "Make sequences of this many frames instead of scenes: the camera and some of the things move, and "
                  "things keep their numbers; each is a folder of frames with camera.yaml and poses.txt")
      ->check(number_in(1, 10000))
      ->type_name("N");
  command
      .add_option("--output", options->output,
                  "Folder for <category>[_<sensor>]_<seed>_<index>/{rgb,depth,label}.png and camera.yaml; the "
                  "categories go to a file of "
                  "the folder's name with .csv beside it")
      ->type_name("DIR")
      ->required();
  command.add_option("--sensor", options->sensor, "How depth is measured, one of " + known_names(sensor_model_names()))
      ->capture_default_str();
  CLI::Option& width = *command.add_option("--width", options->width, "Columns of the images")
                            ->check(number_in(40, 8192))
                            ->capture_default_str();
  CLI::Option& height = *command.add_option("--height", options->height, "Rows of the images")
                             ->check(number_in(30, 8192))
                             ->capture_default_str();
  CLI::Option& focal_length = *command
                                   .add_option("--focal-length", options->focal_length,
                                               "Of the camera, pixels; by default that of a Kinect, 525 at 640 columns")
                                   ->check(number_in(20.0, 20000.0))
                                   ->type_name("PX");
  command
      .add_option("--camera", options->camera, "Intrinsics and size of the images, in place of the three options above")
      ->type_name("FILE")
      ->excludes(&width)
      ->excludes(&height)
      ->excludes(&focal_length);
  command.add_option("--threads", options->threads, "Threads to use (0: all); the result is the same for any number")
      ->check(number_in(0, 1024));
  command.callback([options, &run] {
    run = [options] { return options->frames > 0 ? synthesize_sequences(*options) : synthesize_scenes(*options); };
  });
}

const Subcommand subcommand(70, add_synthesize);

}  // namespace

}  // namespace gestalt::app::synthesize_command
