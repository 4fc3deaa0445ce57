// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "gestalt/tests/environment/temporary_folder.h"
#include "run_gestalt.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

// That what is written builds and works is tested in tests/sdk.

TEST(NewPlugin, WritesAProjectUnderItsOwnName) {
  const TemporaryFolder folder;
  for (const char* kind : {"clusterer", "fitter", "relation", "classifier", "solver"}) {
    const fs::path project = folder.path() / kind;
    expect_success(run_gestalt({"new-plugin", kind, "red_2_blue", project}));
    EXPECT_EQ(files_below(project), (Texts{".gitignore", "CMakeLists.txt", "README.md", "config.yaml", "plugin.cpp",
                                           "red_2_blue.cpp", "red_2_blue.h", "red_2_blue_test.cpp"}));
    for (const std::string& file : files_below(project))
      for (const char* word : {"my_component", "MyComponent", "my_kind"})
        EXPECT_EQ(occurrences(word, content(project / file)), 0) << kind << '/' << file;
    EXPECT_EQ(occurrences("class Red2Blue final", content(project / "red_2_blue.h")), 1) << kind;
    EXPECT_EQ(occurrences("KIND " + std::string(kind), content(project / "CMakeLists.txt")), 1) << kind;
  }
}

TEST(NewPlugin, TheFolderIsNamedAsThePluginWhereNoneIsGiven) {
  const TemporaryFolder folder;
  const Outcome outcome = run_gestalt({"new-plugin", "solver", "mine"}, {.folder = folder.path()});
  expect_success(outcome);
  EXPECT_TRUE(fs::exists(folder.path() / "mine" / "mine.h"));
  EXPECT_EQ(occurrences("cmake -S mine -B mine/build", outcome.out), 1) << outcome.out;
}

TEST(NewPlugin, TakesAnEmptyFolderAndNoOther) {
  const TemporaryFolder folder;
  fs::create_directory(folder.path() / "empty");
  expect_success(run_gestalt({"new-plugin", "solver", "mine", folder.path() / "empty"}));
  folder.write("full/precious.txt", "x");
  for (const fs::path& taken : {folder.path() / "full", folder.path() / "full" / "precious.txt"})
    expect_refused(run_gestalt({"new-plugin", "solver", "mine", taken}), 2, {taken, "new or empty"});
  EXPECT_EQ(files_below(folder.path() / "full"), Texts{"precious.txt"});
}

TEST(NewPlugin, RefusesWhatIsNoKindNoNameAndTaken) {
  const TemporaryFolder folder;
  const fs::path project = folder.path() / "project";
  expect_refused(run_gestalt({"new-plugin", "relatoin", "mine", project}), 2, {"relatoin", "did you mean 'relation'?"});
  for (const char* name : {"Mine", "2nd", "a b", "../x", "a__b", "a_", "_a"})
    expect_refused(run_gestalt({"new-plugin", "relation", name, project}), 2, {"is not a valid plugin name"});
  expect_refused(run_gestalt({"new-plugin", "relation", "gabor", project}), 2,
                 {"'gabor' already", "relation_gabor.so"});
  EXPECT_FALSE(fs::exists(project));
}

TEST(NewPlugin, SaysWhereItCannotWrite) {
  const TemporaryFolder folder;
  const fs::path file = folder.write("file", "x");
  expect_refused(run_gestalt({"new-plugin", "solver", "mine", file / "project"}), 1, {file / "project"});
}

TEST(InstalledConfig, IsFoundByItsNameWhereThereIsNoSuchFile) {
  const TemporaryFolder folder;
  const fs::path mine = folder.write("mine.yaml", "schema_version: 1\nextends: realtime.yaml\n");
  expect_success(run_gestalt({"config", "check", mine}));
  expect_success(run_gestalt({"config", "check", "ablation/assembly_only_r_co.yaml"}, {.folder = folder.path()}));
  folder.write("paper.yaml", "schema_version: 2\n");
  expect_refused(run_gestalt({"config", "check", "paper.yaml"}, {.folder = folder.path()}), 2, {"schema_version"});
}

}  // namespace
}  // namespace gestalt::test
