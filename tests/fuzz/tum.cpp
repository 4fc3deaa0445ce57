// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The lists of a TUM sequence: rgb.txt and depth.txt.

#include "gestalt/io/dataset/tum_sequence.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  const std::vector<std::string_view> parts = parts_of(text_of(data, size), 2);
  scratch.write("rgb.txt", parts[0]);
  return expect_result_or_error([&] { find_tum_frames(scratch.write("depth.txt", parts[1]).parent_path()); });
}
