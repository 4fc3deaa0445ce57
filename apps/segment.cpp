// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <iomanip>
#include <memory>
#include <sstream>

#include "command.h"
#include "scene_batch.h"
#include "segmenter.h"

namespace gestalt::app {

namespace {

struct Options {
  std::vector<std::filesystem::path> inputs;
  SegmenterOptions segmenter;
};

int segment(const Options& options) {
  const ThreadLimit limit(options.segmenter.pipeline.threads);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.inputs);
  const Segmenter segmenter(options.segmenter);
  return for_each_scene(scenes, [&](const std::filesystem::path& scene) {
    const SegmentedScene done = segmenter.segment(scene);
    std::ostringstream line;
    line << done.folder.string() << ": " << done.segments << " segments of " << done.patches << " patches, "
         << std::fixed << std::setprecision(0) << done.milliseconds << " ms";
    return line.str();
  });
}

}  // namespace

void add_segment(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("segment", "Segment scenes into objects");
  command->add_option("inputs", options->inputs, "Scene folders, files (.pcd, .ply, .npz), or folders of those")
      ->required()
      ->type_name("INPUT");
  add_segmenter_options(*command, options->segmenter);
  command->footer(
      "Example: gestalt segment examples/demo_scene --output out\n"
      "         gestalt segment cloud.ply --camera camera.yaml --also pcd,coco");
  command->callback([options, &run] { run = [options] { return segment(*options); }; });
}

}  // namespace gestalt::app
