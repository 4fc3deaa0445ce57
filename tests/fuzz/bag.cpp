// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Recordings of ROS and the frames in them.

#include "gestalt/io/bag/bag_frames.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  return expect_result_or_error([&] {
    const BagFrames frames(scratch.write("recording", text_of(data, size)));
    if (!frames.frames().empty()) frames.read(frames.frames().front());
  });
}
