// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// scene_camera.json of a BOP scene.

#include "gestalt/io/dataset/bop_scene.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const bool written = [] { return scratch.write("depth/000001.png", ""), true; }();
  (void)written;
  return expect_result_or_error([&] {
    const std::filesystem::path scene = scratch.write("scene_camera.json", text_of(data, size)).parent_path();
    for (const BopImage& image : find_bop_images(scene)) expect_result_or_error([&] { read_bop_image(image); });
  });
}
