// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// A batch that is interrupted, killed or runs out of disk leaves whole results or none, and --resume goes on from
// there.

#include <gtest/gtest.h>

#include <chrono>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const Texts result_files{"labels.png", "objects.png", "overlay.png", "patches.png", "result.json"};

/// A result folder's files by name, result.json without what a run's speed decides.
std::map<std::string, std::string> whole_result(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const std::string& name : files_below(folder)) files[name] = content(folder / name);
  json result = json::parse(files.at("result.json"));
  result.erase("milliseconds");
  files["result.json"] = result.dump();
  return files;
}

class Interrupted : public testing::Test {
 protected:
  Outcome segment(const Texts& more = {}, const Surroundings& surroundings = {}) const {
    return run_gestalt(joined({"segment", scenes, "--output", out, "--threads", "1"}, more), surroundings);
  }

  /// After the first scene of four.
  Outcome segment_and_send(int signal) const {
    return segment({}, {.interrupt_after = out / names.front() / "result.json", .signal = signal});
  }

  void expect_results_of_an_undisturbed_run() const {
    const fs::path undisturbed = folder.path() / "undisturbed";
    if (!fs::exists(undisturbed)) expect_success(run_gestalt({"segment", scenes, "--output", undisturbed}));
    for (const std::string& name : names) EXPECT_EQ(whole_result(out / name), whole_result(undisturbed / name)) << name;
    EXPECT_EQ(files_below(out), files_below(undisturbed));
  }

  /// Those of a resumed run.
  int left_alone(const Texts& more = {}) const {
    const Outcome outcome = segment(joined({"--resume"}, more));
    expect_success(outcome);
    EXPECT_EQ(occurrences("\n", outcome.out), 4);
    return occurrences("already done, skipped", outcome.out);
  }

  TemporaryFolder folder;
  const fs::path scenes = [this] {
    fs::copy(synthetic_scenes(), folder.path() / "scenes", fs::copy_options::recursive);
    return folder.path() / "scenes";
  }();
  const fs::path out = folder.path() / "out";
  const Texts names = [] {
    Texts four;
    for (int i = 0; i < 4; ++i) four.push_back(synthetic_scene(i).filename());
    return four;
  }();
};

TEST_F(Interrupted, ASignalEndsTheBatchAfterTheScenesAtWork) {
  for (const int signal : {SIGINT, SIGTERM}) {
    const Outcome outcome = segment_and_send(signal);
    EXPECT_EQ(outcome.code, 128 + signal);
    EXPECT_EQ(occurrences("interrupted: ", outcome.err), 1) << outcome.err;
    EXPECT_EQ(occurrences(" of 4 scenes were not started", outcome.err), 1) << outcome.err;
    const int done = occurrences("\n", outcome.out);
    EXPECT_GE(done, 1);
    EXPECT_LT(done, 4);
    EXPECT_EQ(files_below(out).size(), std::size_t(done) * result_files.size());
    EXPECT_EQ(left_alone(), done);
    expect_results_of_an_undisturbed_run();
    fs::remove_all(out);
  }
}

TEST_F(Interrupted, ASignalEndsTheOnlySceneWithAWholeResultOrNone) {
  const Outcome outcome = run_gestalt({"segment", synthetic_scene(), "--output", out, "--debug-images"},
                                      {.interrupt_after = out / names.front(), .signal = SIGTERM});
  EXPECT_EQ(outcome.code, 128 + SIGTERM);
  for (const std::string& name : result_files) EXPECT_TRUE(fs::exists(out / names.front() / name)) << name;
}

TEST_F(Interrupted, AKilledBatchIsResumed) {
  EXPECT_EQ(segment_and_send(SIGKILL).code, 128 + SIGKILL);
  // What a write that was under way leaves.
  fs::create_directories(out / names[1]);
  std::ofstream(out / names[1] / ".gestalt-0123456789abcdef.tmp") << "half";
  EXPECT_GE(left_alone(), 1);
  expect_results_of_an_undisturbed_run();
}

TEST_F(Interrupted, ResumingLeavesOutWhatWouldBeTheSame) {
  expect_success(segment());
  EXPECT_EQ(left_alone(), 4);
  EXPECT_EQ(left_alone({"--set", "time_budget=60000"}), 4);
  EXPECT_EQ(left_alone({"--set", "structural.negatives=1000"}), 0);
  EXPECT_EQ(left_alone({"--set", "structural.negatives=1000"}), 4);
  EXPECT_EQ(left_alone(), 0);
  EXPECT_EQ(left_alone({"--camera", scenes / "camera.yaml"}), 0);
  EXPECT_EQ(left_alone({"--also", "ply", "--camera", scenes / "camera.yaml"}), 0);
  EXPECT_EQ(left_alone({"--camera", scenes / "camera.yaml"}), 4);
}

TEST_F(Interrupted, ResumingKnowsTheLabelsOfClouds) {
  const fs::path cloud = folder.path() / "cloud.ply";
  std::ofstream(cloud) << "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                          "property float z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\n"
                          "end_header\n0 0 1 9 9 9\n0.01 0 1 9 9 9\n0 0.01 1 9 9 9\n";
  const auto resume = [&] {
    return run_gestalt({"segment", cloud, "--camera", scenes / "camera.yaml", "--output", out, "--resume"});
  };
  expect_success(resume());
  EXPECT_EQ(occurrences("already done, skipped", resume().out), 1);
  ASSERT_TRUE(fs::remove(out / "cloud" / "labels.pcd"));
  EXPECT_EQ(occurrences("already done, skipped", resume().out), 0);
  EXPECT_TRUE(fs::exists(out / "cloud" / "labels.pcd"));
}

TEST_F(Interrupted, ResumingSeesThatAFileOfTheSceneIsGone) {
  expect_success(segment());
  ASSERT_TRUE(fs::remove(scenes / names[1] / "label.png"));
  EXPECT_EQ(left_alone(), 3);
}

TEST_F(Interrupted, ResumingDoesAgainWhatIsIncomplete) {
  expect_success(segment());
  fs::remove(out / names[0] / "overlay.png");
  truncate(out / names[1] / "result.json", 0.5);
  EXPECT_EQ(left_alone(), 2);
  EXPECT_EQ(left_alone(), 4);
  expect_results_of_an_undisturbed_run();
}

/// A file of a scene takes the place of another's, with the time of long ago, as rsync, tar and `cp -p` have it.
void replace(const fs::path& file, const fs::path& by) {
  fs::remove(file);
  fs::copy(by, file);
  fs::last_write_time(file, fs::file_time_type::clock::now() - std::chrono::hours(24 * 365));
}

TEST_F(Interrupted, ResumingGoesByContentNotByTimes) {
  expect_success(segment());
  for (const char* file : {"depth.png", "rgb.png"})
    fs::last_write_time(scenes / names[0] / file, fs::file_time_type::clock::now() + std::chrono::hours(1));
  EXPECT_EQ(left_alone(), 4) << "a time alone is not a change";
  replace(scenes / names[1] / "depth.png", scenes / names[2] / "depth.png");
  EXPECT_EQ(left_alone(), 3);
  EXPECT_EQ(left_alone(), 4);

  // A nearer camera, and one that is changed.
  replace(scenes / names[3] / "camera.yaml", scenes / "camera.yaml");
  EXPECT_EQ(left_alone(), 4) << "the same camera";
  const std::string camera = content(scenes / "camera.yaml");
  replace(scenes / names[3] / "camera.yaml", folder.write("nearer.yaml", camera + "# of another day\n"));
  EXPECT_EQ(left_alone(), 3);
  replace(scenes / "camera.yaml", folder.path() / "nearer.yaml");
  EXPECT_EQ(left_alone(), 1) << "of the one that has its own";
}

TEST_F(Interrupted, ResumingSeesWhereALinkLeads) {
  const fs::path linked = folder.path() / "linked";
  fs::create_directory(linked);
  fs::copy(scenes / "camera.yaml", linked);
  const auto lead = [&](int scene) {
    fs::remove(linked / "a");
    fs::create_directory_symlink(scenes / names[std::size_t(scene)], linked / "a");
  };
  const auto resume = [&] {
    const Outcome outcome = run_gestalt({"segment", linked / "a", "--output", out, "--resume"});
    expect_success(outcome);
    return occurrences("already done, skipped", outcome.out);
  };
  lead(0);
  EXPECT_EQ(resume(), 0);
  EXPECT_EQ(resume(), 1);
  lead(1);
  EXPECT_EQ(resume(), 0);
  fs::create_symlink(linked / "nowhere", scenes / names[1] / "notes");
  EXPECT_EQ(resume(), 1) << "a link to nowhere has no content";
}

TEST_F(Interrupted, ResumingKnowsResultsInTheScenesOwnFolders) {
  const auto resume = [&](const Texts& more) {
    const Outcome outcome = run_gestalt(joined({"segment", scenes, "--output", scenes, "--resume"}, more));
    expect_success(outcome);
    return occurrences("already done, skipped", outcome.out);
  };
  EXPECT_EQ(resume({}), 0);
  EXPECT_EQ(resume({}), 4);
  EXPECT_EQ(resume({"--also", "ply", "--debug-images"}), 0);
  EXPECT_EQ(resume({}), 4);
}

TEST_F(Interrupted, ResumingKnowsScenesWhosePathIsNoUtf8) {
  const fs::path scene = folder.path() / "caf\xe9" / "sc\xe8ne";
  fs::create_directory(scene.parent_path());
  fs::copy(scenes / names[0], scene);
  fs::copy(scenes / "camera.yaml", scene);
  const Texts command{"segment", scene, "--output", out, "--resume"};
  expect_success(run_gestalt(command));
  EXPECT_EQ(occurrences("already done, skipped", run_gestalt(command).out), 1);
}

TEST_F(Interrupted, ResumingSeesThatAPluginWasBuiltAnew) {
  const fs::path built = fs::path(BROKEN_PLUGINS) / "misbehaving" / "misbehaving.so", mine = folder.path() / "plugins";
  fs::create_directory(mine);
  fs::copy(built, mine);
  const auto resume = [&] {
    const Outcome outcome = run_gestalt({"segment", scenes / names[0], "--output", out, "--resume", "--set",
                                         "decision.solver=misbehaving", "--set", "decision.solver.params.how=linger"},
                                        {.variables = {"GESTALT_PLUGIN_PATH=" + mine.string()}});
    expect_success(outcome);
    return occurrences("already done, skipped", outcome.out);
  };
  EXPECT_EQ(resume(), 0);
  EXPECT_EQ(resume(), 1);
  std::ofstream(mine / built.filename(), std::ios::app) << "of another build";
  EXPECT_EQ(resume(), 0);
}

TEST_F(Interrupted, AFullDiskLeavesNoPartOfAResult) {
  const Outcome outcome = segment({}, {.file_size = 20000});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("cannot be written: File too large; check permission and free space", outcome.err), 4);
  EXPECT_EQ(files_below(out), Texts{});
}

TEST_F(Interrupted, AFullDiskLeavesTheEarlierResult) {
  expect_success(segment());
  const auto earlier = whole_result(out / names[0]);
  EXPECT_EQ(segment({"--set", "structural.negatives=1000"}, {.file_size = 20000}).code, 1);
  EXPECT_EQ(whole_result(out / names[0]), earlier);
}

}  // namespace
}  // namespace gestalt::test
