// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// categories.csv of a folder of scenes.

#include "gestalt/evaluation/score/evaluation.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  return expect_result_or_error([&] { read_categories(scratch.write("categories.csv", text_of(data, size))); });
}
