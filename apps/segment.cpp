// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iomanip>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>

#include "command.h"
#include "gestalt/input.h"
#include "gestalt/result.h"
#include "pipeline_options.h"
#include "scene_batch.h"

namespace gestalt::app {

namespace {

struct Options {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output = "out";
  std::filesystem::path camera;
  bool debug_images = false;
  PipelineOptions pipeline;
};

/// Pictures of what the levels below the segments found, by file name.
std::vector<OutputFile> debug_images(const std::filesystem::path& folder, const Pipeline& pipeline, Frame frame,
                                     const Percept& percept) {
  frame.noise = pipeline.noise();
  const Scene scene(frame, percept.patches, percept.surfaces);
  return {{folder / "lines.png", encode_png(draw_boundary_lines(scene))}};
}

int segment(const Options& options) {
  const ThreadLimit limit(options.pipeline.threads);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.inputs);
  const LoadedConfig loaded = load_config(options.pipeline);
  const nlohmann::json config = loaded.tree.to_json(loaded.registry);
  const Pipeline pipeline(loaded.config, loaded.registry);
  const Models models = load_models(pipeline);
  std::optional<CameraFile> camera;
  if (!options.camera.empty()) camera = read_camera(options.camera);

  return for_each_scene(scenes, [&](const std::filesystem::path& scene) {
    const Input input = read_scene(scene, camera);
    const Percept percept = pipeline.perceive(input.frame);
    LevelTimes times = percept.times;
    const Segmentation segmentation = pipeline.decide(percept, models, &times);
    const std::filesystem::path folder = options.output / input.frame.name;
    std::vector<OutputFile> pictures;
    if (options.debug_images) pictures = debug_images(folder, pipeline, input.frame, percept);
    write_result(folder, input, percept, segmentation, times, config, std::move(pictures));
    std::ostringstream line;
    line << folder.string() << ": " << segmentation.segments.size() << " segments of "
         << percept.surfaces.surfaces.size() << " patches, " << std::fixed << std::setprecision(0) << times.total()
         << " ms";
    return line.str();
  });
}

}  // namespace

void add_segment(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("segment", "Segment scenes into objects");
  command->add_option("inputs", options->inputs, "Scene folders, PCD files, or folders of those")
      ->required()
      ->type_name("INPUT");
  command->add_option("--output", options->output, "Folder for the results, one folder for each scene")
      ->check(not_empty)
      ->capture_default_str()
      ->type_name("DIR");
  command->add_option("--camera", options->camera, "Intrinsics to use instead of the scene's camera.yaml")
      ->type_name("FILE");
  command->add_flag("--debug-images", options->debug_images,
                    "Write lines.png too: boundary lines, their junctions, collinearities and closures");
  add_pipeline_options(*command, options->pipeline);
  command->footer("Example: gestalt segment examples/demo_scene --output out");
  command->callback([options, &run] { run = [options] { return segment(*options); }; });
}

}  // namespace gestalt::app
