// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Any image file, JPEG, TIFF, PGM, EXR, npy, ..., as the colour image of a scene folder and as its depth image.

#include "gestalt/io/scene/image_file.h"

#include "gestalt/io/scene/input.h"
#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  const std::filesystem::path file = scratch.write("scene/depth.tif", text_of(data, size));
  scratch.write("scene/rgb.jpg", text_of(data, size));
  static const bool written = [] {
    return scratch.write("scene/camera.yaml", "width: 4\nheight: 3\nfx: 5\nfy: 5\ncx: 2\ncy: 1\n"), true;
  }();
  (void)written;
  expect_result_or_error([&] { is_depth_image(file); });
  return expect_result_or_error([&] { read_scene(file.parent_path()); });
}
