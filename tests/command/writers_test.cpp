// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Two runs that write into one output, and what readers make of files that do not belong together.

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <thread>

#include "gestalt/core/base/digest.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Writers : public testing::Test {
 protected:
  Outcome segment(const Texts& more = {}) const {
    return run_gestalt(joined({"segment", scene, "--output", out}, more));
  }

  /// Of the files that result.json names.
  void expect_whole() const {
    const json files = json::parse(content(result)).at("files");
    EXPECT_GE(files.size(), 4u);
    for (const auto& [name, told] : files.items()) EXPECT_EQ(file_digest(result.parent_path() / name), told) << name;
    EXPECT_EQ(files_below(out).size(), files.size() + 1);
  }

  const TemporaryFolder folder;
  const fs::path scene = synthetic_scene(), out = folder.path() / "out", at_scene = out / scene.filename(),
                 result = at_scene / "result.json";
};

TEST_F(Writers, OfOneSceneLeaveTheFilesOfOneOfThem) {
  for (int round = 0; round < 3; ++round) {
    std::jthread other([&] { EXPECT_EQ(segment({"--set", "structural.minimum_size=400"}).code, 0); });  // a warning
    expect_success(segment());
    other.join();
    expect_whole();
  }
}

TEST_F(Writers, FilesOfAnotherRunAreTold) {
  expect_success(segment());
  expect_whole();
  const fs::path labels = at_scene / "labels.png", mesh = folder.path() / "mesh.ply";
  const Texts evaluate{"evaluate", scene, "--predictions", out};
  expect_success(run_gestalt(evaluate));
  expect_success(run_gestalt({"info", result}));
  fs::copy_file(at_scene / "objects.png", labels, fs::copy_options::overwrite_existing);

  expect_refused(run_gestalt(evaluate), 3, {"labels.png: does not match the result.json", "segment the scene again"});
  const std::string told =
      "result.json: does not match the files beside it, which come from another run or were changed since: labels.png;";
  for (const Texts& reader : {Texts{"info", result},
                              {"export", result, "--output", mesh},
                              {"inspect", result, "--output", folder.path() / "page.html"}}) {
    const Outcome outcome = run_gestalt(reader);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(occurrences(told, outcome.err), 1) << outcome.err;
  }
  EXPECT_EQ(json::parse(run_gestalt({"info", result, "--json"}).out).at("foreign_files"), json{"labels.png"});

  const Outcome again = segment({"--resume"});
  EXPECT_EQ(occurrences("already done, skipped", again.out), 0) << again.out;
  expect_success(again);
  expect_whole();
  EXPECT_EQ(occurrences("already done, skipped", segment({"--resume"}).out), 1);

  fs::copy_file(at_scene / "objects.png", labels, fs::copy_options::overwrite_existing);
  fs::remove(result);  // as the message says
  expect_success(run_gestalt(evaluate));
}

TEST_F(Writers, ResultsOfOtherProgramsBesideLabelsAreTheirs) {
  expect_success(segment());
  folder.write(result, R"({"files": {"labels.png": "no digest of ours"}})");
  expect_success(run_gestalt({"evaluate", scene, "--predictions", out}));
}

// Only files beside it are looked at.
TEST_F(Writers, NamesInAResultLeadNowhere) {
  expect_success(segment());
  json content_of_result = json::parse(content(result));
  content_of_result["files"] = {
      {"../" + scene.filename().string() + "/labels.png", ""}, {"/etc/passwd", ""}, {"", ""}, {"missing", ""}};
  folder.write(result, content_of_result.dump());
  expect_success(run_gestalt({"info", result}));
}

}  // namespace
}  // namespace gestalt::test
