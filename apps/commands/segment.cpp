// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <algorithm>
#include <iomanip>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <sstream>

#include "command.h"
#include "gestalt/apps/counted.h"
#include "gestalt/apps/frame_options.h"
#include "gestalt/apps/next_step.h"
#include "gestalt/apps/scene_batch.h"
#include "gestalt/apps/scene_segmenter.h"
#include "gestalt/apps/viewer.h"
#include "gestalt/io/scene/scene_format.h"

namespace gestalt::app::segment_command {

namespace {

struct Options {
  std::vector<std::filesystem::path> inputs;
  FrameOptions frame;
  bool view = false;
  bool resume = false;
  SegmenterOptions segmenter;
};

/// Whether the scene is read without options, so that `inspect` needs none either.
bool has_its_camera(const Options& options) {
  const ReadingOptions& reading = options.segmenter.reading;
  return options.frame.depth.empty() && reading.colour.empty() && reading.camera.empty() && !reading.fx &&
         text_of(reading) == text_of({});
}

int segment(const Options& options) {
  std::optional<Viewer> viewer;
  SegmenterOptions with_clouds = options.segmenter;
  if (options.view) {
    viewer.emplace();
    with_clouds.also.push_back("pcd");
  }
  const ThreadLimit limit(options.segmenter.pipeline.threads);
  const std::vector<std::filesystem::path> scenes = find_scenes(options.inputs);
  const SceneSegmenter segmenter(with_clouds);
  std::mutex mutex;
  std::map<std::filesystem::path, std::filesystem::path> written;  // by scene
  const int code = for_each_scene(scenes, [&](const std::filesystem::path& scene) {
    if (options.resume && segmenter.has_segmented(scene)) {
      const std::filesystem::path folder = segmenter.folder_of(scene);
      const std::lock_guard lock(mutex);
      written.emplace(scene, folder);
      return folder.string() + ": already done, skipped";
    }
    const SegmentedScene done = segmenter.segment(scene);
    std::ostringstream line;
    line << done.folder.string() << ": " << counted(done.objects, "object") << ", " << counted(done.patches, "patch")
         << ", " << std::fixed << std::setprecision(0) << done.milliseconds << " ms";
    const std::lock_guard lock(mutex);
    written.emplace(scene, done.folder);
    return line.str();
  });
  if (!viewer && written.size() == 1 && scenes.size() == 1 && has_its_camera(options))
    suggest_next("See why in a browser", {"inspect", written.begin()->second, "--output", "page.html"});
  if (!viewer || written.empty() || code > 128) return code;
  std::vector<std::filesystem::path> results;
  for (const std::filesystem::path& scene : scenes)
    if (const auto found = written.find(scene); found != written.end()) results.push_back(found->second);
  return std::max(code, viewer->show(results));
}

void add_segment(CLI::App& app, Run& run) {
  const auto options = std::make_shared<Options>();
  CLI::App* command = app.add_subcommand("segment", "Segment scenes into objects");
  command
      ->add_option("inputs", options->inputs,
                   "Scene folders, files (" + scene_extensions(", ") +
                       "), folders of those, recordings (rgb/ and depth/), or a colour and a depth image")
      ->type_name("INPUT");
  add_frame_options(*command, options->frame);
  add_segmenter_options(*command, options->segmenter);
  command->add_flag("--resume", options->resume,
                    "Skip scenes whose results are complete and come from the same input, config, model, --camera and "
                    "version; continues an interrupted run");
  command->add_flag(
      "--view", options->view,
      "Show the results in PCL's viewer afterwards (needs a display and gestalt-view); implies --also pcd");
  command->footer(
      "Example: gestalt segment examples/demo_scene --output out\n"
      "         gestalt segment --rgb rgb.jpg --depth depth.png --camera camera.yaml\n"
      "         gestalt segment cloud.ply --camera camera.yaml --also pcd,coco\n"
      "         gestalt segment examples/demo_scene --view");
  command->callback([options, &run] {
    require_input_or_frame(options->inputs, options->frame);
    run = [options] {
      options->inputs = inputs_with_frame(options->inputs, options->frame);
      options->segmenter.reading.colour = options->frame.colour;
      return segment(*options);
    };
  });
}

const Subcommand subcommand(10, add_segment);

}  // namespace

}  // namespace gestalt::app::segment_command
