// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// result.json, as `export` reads it: the surfaces must have triangles, too.

#include "gestalt/io/result/result_file.h"

#include "scratch.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace gestalt;
  using namespace gestalt::fuzz;
  static const Scratch scratch;
  return expect_result_or_error([&] {
    TriangulationBudget budget;
    for (const TrimmedSurface& surface : read_result(scratch.write("result.json", text_of(data, size))).patches)
      expect_result_or_error([&] { triangulate(surface, 0.001, budget); });
  });
}
