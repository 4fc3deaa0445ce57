// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Camera files: ours, and camera_info of ROS.

#include "gestalt/io/scene/input.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  return expect_result_or_error([&] { read_camera(scratch.write("camera.yaml", text_of(data, size))); });
}
