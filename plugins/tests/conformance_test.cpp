// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The conformance suite itself: it must find what is wrong, and must not pass where there is nothing to check.

#include <gtest/gtest.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <regex>
#include <set>
#include <string>

namespace {

struct Verdict {
  int exit_code;
  std::set<std::string> tests;   ///< "Suite.Test" of all that ran
  std::set<std::string> failed;  ///< those that failed for some component
  std::string output;
};

Verdict check(const std::string& folder) {
  const std::string command = CONFORMANCE " --plugins " BROKEN_PLUGINS "/" + folder + " --gtest_color=no 2>&1";
  FILE* pipe = ::popen(command.c_str(), "r");
  Verdict run;
  for (std::array<char, 4096> part; std::fgets(part.data(), part.size(), pipe);) run.output += part.data();
  run.exit_code = WEXITSTATUS(::pclose(pipe));
  const std::regex line(R"(\[( RUN      |  FAILED  )\] (?:Plugins/)?(\w+\.\w+))");
  for (std::sregex_iterator match(run.output.begin(), run.output.end(), line), end; match != end; ++match)
    ((*match)[1] == " RUN      " ? run.tests : run.failed).insert((*match)[2]);
  return run;
}

TEST(Conformance, FailsWhereThereIsNoComponent) {
  const Verdict run = check("not_there");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.failed.contains("Plugins.AreThere")) << run.output;
}

TEST(Conformance, FailsWhenALibraryIsRejected) {
  const Verdict run = check("undefined_symbol");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_TRUE(run.failed.contains("Plugins.AreAllTaken")) << run.output;
}

// Each test of a component must be able to fail: there is a fault for it in broken/unfit.cpp.
TEST(Conformance, EveryTestFindsItsFault) {
  const Verdict run = check("unfit");
  EXPECT_EQ(run.exit_code, 1);
  EXPECT_GT(run.tests.size(), 30u) << run.output;
  for (const std::string& test : run.tests) EXPECT_EQ(run.failed.contains(test), !test.starts_with("Plugins.")) << test;
}

}  // namespace
