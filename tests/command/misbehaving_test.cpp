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
  Outcome segment_with(const std::string& how, const std::string& time_budget = "0", std::size_t memory = 0) const {
    const std::string plugins = fs::path(BROKEN_PLUGINS) / "misbehaving";
    return run_gestalt({"segment", write_scene(folder.path() / "scene", small_wall()), "--output", out, "--set",
                        "decision.solver=misbehaving", "--set", "decision.solver.params.how=" + how, "--set",
                        "time_budget=" + time_budget},
                       {.variables = {"GESTALT_PLUGIN_PATH=" + plugins}, .memory = memory});
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

TEST_F(Misbehaving, WhoTakesTooLongEndsTheFrame) {
  expect_refused(segment_with("linger", "3000"), 1, {"time_budget of 3000 ms", "solver 'misbehaving' was running"});
  EXPECT_EQ(files_below(out), Texts{});
  EXPECT_EQ(segment_with("linger", "60000").code, 0);
  // Ten times this budget is less than it takes, but it does return.
  expect_refused(segment_with("linger", "300"), 1, {"time_budget of 300 ms"});
}

TEST_F(Misbehaving, WhoNeverReturnsEndsTheProcess) {
  expect_refused(segment_with("hang", "1000"), 1,
                 {"with a time_budget of 1000 ms; running: solver 'misbehaving'", "scene"});
  EXPECT_EQ(files_below(out), Texts{});
}

// A sanitizer takes terabytes of address space.
#ifndef GESTALT_UNDER_SANITIZER
TEST_F(Misbehaving, WhoAllocatesWithoutEndIsAnErrorUnderALimit) {
  expect_refused(segment_with("allocate", "0", std::size_t{1} << 30), 2, {"solver 'misbehaving' failed", "memory"});
  EXPECT_EQ(files_below(out), Texts{});
}
#endif

TEST_F(Misbehaving, WhoEndsTheProcessFails) {
  for (const char* how : {"exit", "quick_exit", "exit_elsewhere"})
    expect_refused(segment_with(how), 1, {"exit() was called while solver 'misbehaving' was running"});
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
