// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// gestalt_plugin_conformance [--plugins DIRECTORY]... [GoogleTest options]
//
// Checks every component of every plugin in the directories against the contract of its kind; without --plugins, those
// that the gestalt command finds. It fails, too, when a library there is rejected or there is no component at all.

#include <gtest/gtest.h>

#include <iostream>
#include <string_view>

#include "gestalt/core/base/error.h"
#include "subjects.h"

int main(int argc, char** argv) {
  std::vector<std::filesystem::path> directories;
  int kept = 1;
  for (int i = 1; i < argc; ++i) {
    if (std::string_view(argv[i]) != "--plugins")
      argv[kept++] = argv[i];
    else if (++i < argc)
      directories.emplace_back(argv[i]);
  }
  argc = kept;
  if (directories.empty()) directories = gestalt::plugin_search_path({});
  try {
    // Before InitGoogleTest(), which asks for the subjects to name the tests.
    gestalt::conformance::load_subjects(std::move(directories));
  } catch (const gestalt::Error& error) {
    std::cerr << error.what() << '\n';
    return 2;
  }
  testing::InitGoogleTest(&argc, argv);
  return RUN_ALL_TESTS();
}
