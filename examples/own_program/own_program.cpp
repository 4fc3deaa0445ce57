// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// own_program SCENE: prints the objects of a scene, largest first. A program makes the segmenter once and then calls
// segment() for each frame, from as many threads as it likes.

#include <gestalt/core/pipeline/segmenter.h>
#include <gestalt/io/scene/input.h>

#include <cstdio>
#include <exception>

int main(int argc, char** argv) try {
  if (argc != 2) {
    std::fprintf(stderr, "usage: own_program SCENE\n");
    return 2;
  }
  const gestalt::Segmenter segmenter;
  // A frame of your own camera: gestalt::make_frame(name, colour, depth, camera).
  const gestalt::Frame frame = gestalt::read_scene(argv[1]).frame;
  const gestalt::Segmentation segmentation = segmenter.segment(frame).segmentation;
  for (std::size_t i = 0; i < segmentation.segments.size(); ++i) {
    const gestalt::Segment& segment = segmentation.segments[i];
    if (segment.role == gestalt::Role::object)
      std::printf("object %zu: %d pixels, %zu surfaces\n", i + 1, segment.pixel_count, segment.surfaces.size());
  }
  return 0;
} catch (const std::exception& error) {
  std::fprintf(stderr, "own_program: %s\n", error.what());
  return 1;
}
