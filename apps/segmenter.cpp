// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "segmenter.h"

#include <algorithm>

#include "command.h"
#include "gestalt/result.h"

namespace gestalt::app {

namespace {

/// Pictures of what the levels below the segments found, by file name.
std::vector<OutputFile> debug_images(const std::filesystem::path& folder, const Pipeline& pipeline, Frame frame,
                                     const Percept& percept, const Graph& graph) {
  frame.noise = pipeline.noise();
  const Scene scene(frame, percept.patches, percept.surfaces);
  return {{folder / "normals.png", encode_png(draw_normals(percept.patches.normals))},
          {folder / "signal_patches.png", encode_png(draw_patches(percept.patches.labels))},
          {folder / "surfaces.png", encode_png(draw_normals(surface_normals(frame, percept.surfaces)))},
          {folder / "lines.png", encode_png(draw_boundary_lines(scene))},
          {folder / "graph.png", encode_png(draw_graph(frame, percept.surfaces, graph))}};
}

}  // namespace

void add_segmenter_options(CLI::App& command, SegmenterOptions& options) {
  command.add_option("--output", options.output, "Folder for the results, one folder for each scene")
      ->check(not_empty)
      ->capture_default_str()
      ->type_name("DIR");
  command.add_option("--camera", options.camera, "Intrinsics to use instead of the scene's camera.yaml")
      ->type_name("FILE");
  command.add_flag(
      "--debug-images", options.debug_images,
      "Write what each level found, too: normals.png, signal_patches.png, surfaces.png, lines.png, graph.png");
  add_pipeline_options(command, options.pipeline);
}

Segmenter::Segmenter(const SegmenterOptions& options)
    : output_(options.output),
      debug_images_(options.debug_images),
      loaded_(load_config(options.pipeline)),
      config_(loaded_.tree.to_json(loaded_.registry)),
      pipeline_(loaded_.config, loaded_.registry),
      models_(load_models(pipeline_)) {
  if (!options.camera.empty()) camera_ = read_camera(options.camera);
}

SegmentedScene Segmenter::segment(const std::filesystem::path& scene) const {
  const Input input = read_scene(scene, camera_);
  const Percept percept = pipeline_.perceive(input.frame);
  LevelTimes times = percept.times;
  const Segmentation segmentation = pipeline_.decide(percept, models_, &times);
  const std::filesystem::path folder = output_ / input.frame.name;
  std::vector<OutputFile> pictures;
  if (debug_images_) pictures = debug_images(folder, pipeline_, input.frame, percept, segmentation.graph);
  write_result(folder, input, percept, segmentation, times, config_, std::move(pictures));
  const auto objects = std::count_if(segmentation.segments.begin(), segmentation.segments.end(),
                                     [](const Segment& segment) { return segment.role == Role::object; });
  return {folder, std::size_t(objects), segmentation.segments.size(), percept.surfaces.surfaces.size(), times.total()};
}

}  // namespace gestalt::app
