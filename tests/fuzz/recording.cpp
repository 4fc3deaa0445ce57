// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// What a recording tells in text: associations.txt, cam_K.txt as a matrix, extrinsics.txt.

#include "gestalt/io/scene/input.h"
#include "scratch.h"

namespace {

/// A PGM image of 16 bits.
std::string depth_image() {
  std::string image = "P5\n4 3\n65535\n";
  for (int i = 0; i < 12; ++i) image += "\x03\xe8";
  return image;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  static const std::filesystem::path depth = [] {
    scratch.write("rgb/1.ppm", "P6\n2 2\n255\n" + std::string(12, 'a'));
    scratch.write("camera_color.yaml", "width: 2\nheight: 2\nfx: 5\nfy: 5\ncx: 1\ncy: 1\n");
    return scratch.write("depth/1.pgm", depth_image());
  }();
  const std::vector<std::string_view> parts = parts_of(text_of(data, size), 3);
  scratch.write("associations.txt", parts[0]);
  scratch.write("cam_K.txt", parts[1]);
  scratch.write("extrinsics.txt", parts[2]);
  expect_result_or_error([&] { find_scenes({depth.parent_path().parent_path()}); });
  return expect_result_or_error([&] { read_scene(depth); });
}
