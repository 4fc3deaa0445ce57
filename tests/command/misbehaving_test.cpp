// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Plugins that fail while they work: what can be contained is an error, what cannot is reported, each with the plugin's
// name.

#include <gtest/gtest.h>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

class Misbehaving : public testing::Test {
 protected:
  Outcome segment_with(const std::string& how) const {
    const std::string plugins = fs::path(BROKEN_PLUGINS) / "misbehaving";
    return run_gestalt({"segment", write_scene(folder.path() / "scene", small_wall()), "--output", out, "--set",
                        "decision.solver=misbehaving", "--set", "decision.solver.params.how=" + how},
                       {.variables = {"GESTALT_PLUGIN_PATH=" + plugins}});
  }

  TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
};

TEST_F(Misbehaving, WhatIsThrownIsAnErrorWithItsName) {
  expect_refused(segment_with("throw"), 2, {"solver 'misbehaving' failed: the moon is full"});
  expect_refused(segment_with("throw_number"), 2, {"solver 'misbehaving' failed"});
  expect_refused(segment_with("no_memory"), 2, {"solver 'misbehaving' failed", "memory"});
  EXPECT_EQ(files_below(out), Texts{});
}

// A sanitizer has a report of its own for these.
#ifndef GESTALT_UNDER_SANITIZER
TEST_F(Misbehaving, WhatEndsTheProcessIsNamed) {
  expect_refused(segment_with("segmentation_fault"), 128 + SIGSEGV, {"segmentation fault", "solver 'misbehaving'"});
  expect_refused(segment_with("recurse"), 128 + SIGSEGV, {"segmentation fault", "solver 'misbehaving'"});
  expect_refused(segment_with("abort"), 128 + SIGABRT, {"abort", "solver 'misbehaving'"});
  EXPECT_EQ(files_below(out), Texts{});
}
#endif

}  // namespace
}  // namespace gestalt::test
