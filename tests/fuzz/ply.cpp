// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Clouds and scenes of .ply, with the intrinsics that they bring or that are fitted to them.

#include "gestalt/io/scene/input.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  return expect_result_or_error([&] { read_scene(scratch.write("scene.ply", text_of(data, size))); });
}
