// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Unorganized clouds, which a camera file turns into an image; and one whose camera file does not belong to it.

#include "gestalt/io/scene/input.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  const std::vector<std::string_view> parts = parts_of(text_of(data, size), 2);
  scratch.write("camera.yaml", parts[0]);
  return expect_result_or_error([&] { read_scene(scratch.write("cloud.pcd", parts[1])); });
}
