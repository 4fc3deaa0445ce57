// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// own_program SCENE: prints the objects of a scene, largest first. A program makes the pipeline once, reads the models
// once, and then calls perceive() and decide() for each frame, from as many threads as it likes.

#include <gestalt/core/base/error.h>
#include <gestalt/core/pipeline/pipeline.h>
#include <gestalt/io/scene/input.h>

#include <cstdio>
#include <exception>

namespace {

gestalt::Pipeline make_pipeline(const std::filesystem::path& config_file) {
  const gestalt::ConfigTree config(config_file, {});
  const gestalt::Registry registry(gestalt::plugin_search_path(config.plugin_directories()));
  return {config.resolve(registry), registry};
}

/// A frame of your own camera: gestalt::make_frame(name, colour, depth, camera).
void print_objects(const gestalt::Pipeline& pipeline, const gestalt::Models& models, const gestalt::Frame& frame) {
  const gestalt::Percept percept = pipeline.perceive(frame);
  const gestalt::Segmentation segmentation = pipeline.decide(percept, models);
  for (std::size_t i = 0; i < segmentation.segments.size(); ++i) {
    const gestalt::Segment& segment = segmentation.segments[i];
    if (segment.role == gestalt::Role::object)
      std::printf("object %zu: %d pixels, %zu surfaces\n", i + 1, segment.pixel_count, segment.surfaces.size());
  }
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: own_program SCENE\n");
    return 2;
  }
  const gestalt::Pipeline pipeline = make_pipeline(gestalt::default_config());
  print_objects(pipeline, pipeline.load_models(), gestalt::read_scene(argv[1]).frame);
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "own_program: %s\n", error.what());
  return 1;
}
