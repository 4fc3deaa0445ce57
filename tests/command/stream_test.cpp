// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <future>
#include <nlohmann/json.hpp>
#include <sstream>
#include <thread>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const Texts all_names{"mixed_objects_1_000", "mixed_objects_1_001", "mixed_objects_1_002", "mixed_objects_1_003"};

/// The objects that standard output holds, one a line.
std::vector<json> lines_of(const Outcome& outcome) {
  std::vector<json> lines;
  std::istringstream text(outcome.out);
  for (std::string line; std::getline(text, line);) lines.push_back(json::parse(line));
  return lines;
}

Texts names_of(const std::vector<json>& lines) {
  Texts names;
  for (const json& line : lines) names.push_back(line.at("frame"));
  return names;
}

std::string paths(const std::vector<int>& scenes) {
  std::string text;
  for (const int scene : scenes) text += synthetic_scene(scene).string() + "\n";
  return text;
}

/// Every test has an empty folder for its results.
class StreamCommand : public testing::Test {
 protected:
  Outcome stream(const Texts& arguments, const Surroundings& surroundings = {}) const {
    return run_gestalt(joined({"stream", "--output", out}, arguments), surroundings);
  }

  void expect_frames(const Outcome& outcome, const Texts& names, std::size_t dropped) const {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(names_of(lines_of(outcome)), names);
    EXPECT_TRUE(outcome.err.starts_with("gestalt: " + std::to_string(names.size()) +
                                        (names.size() == 1 ? " frame, " : " frames, ") + std::to_string(dropped) +
                                        " dropped, 0 failed; latency: median "))
        << outcome.err;
    EXPECT_EQ(occurrences("\n", outcome.err), 1) << outcome.err;
    for (const std::string& name : names) EXPECT_TRUE(fs::exists(out / name / "result.json")) << name;
    EXPECT_EQ(std::size_t(std::distance(fs::directory_iterator(out), {})), names.size());
  }

  TemporaryFolder folder;
  const fs::path out = folder.path() / "out";
};

TEST_F(StreamCommand, AFolderGivesWhatSegmentGives) {
  const fs::path segmented = folder.path() / "segmented";
  expect_success(run_gestalt({"segment", synthetic_scenes(), "--output", segmented}));
  expect_frames(stream({synthetic_scenes()}), all_names, 0);
  ASSERT_EQ(files_below(out), files_below(segmented));
  for (const std::string& file : files_below(out)) {
    if (!file.ends_with("result.json")) {
      EXPECT_EQ(content(out / file), content(segmented / file)) << file;
      continue;
    }
    json streamed = json::parse(content(out / file)), expected = json::parse(content(segmented / file));
    streamed.erase("milliseconds");
    expected.erase("milliseconds");
    EXPECT_EQ(streamed, expected) << file;
  }
}

TEST_F(StreamCommand, ALineTellsOfEveryFrame) {
  const std::vector<json> lines = lines_of(stream({synthetic_scenes()}));
  ASSERT_EQ(lines.size(), 4u);
  for (const json& line : lines) {
    const fs::path result = out / line.at("frame").get<std::string>();
    EXPECT_EQ(line.at("result"), result.string());
    EXPECT_GE(line.at("queued_ms"), 0.0);
    EXPECT_GT(line.at("latency_ms"), line.at("queued_ms"));
    EXPECT_EQ(line.at("dropped"), 0);
    const json told = json::parse(content(result / "result.json"));
    std::size_t objects = 0;
    for (const json& segment : told.at("segments"))
      if (segment.at("role") == "object") ++objects;
    EXPECT_EQ(line.at("objects"), objects);
  }
}

TEST_F(StreamCommand, AQueueOfOneLosesNoFrameAndKeepsTheirOrder) {
  const fs::path list = folder.write("list.txt", paths({2, 0, 3, 1}));
  expect_frames(stream({list, "--queue", "1"}), {all_names[2], all_names[0], all_names[3], all_names[1]}, 0);
}

TEST_F(StreamCommand, OfFramesThatComeAtOnceTheNewestIsNotDropped) {
  expect_frames(stream({folder.write("list.txt", paths({2, 0, 3, 1})), "--drop"}), {all_names[1]}, 3);
  fs::remove_all(out);
  expect_frames(stream({synthetic_scenes(), "--drop"}), {all_names[3]}, 3);
}

TEST_F(StreamCommand, ReadsPathsFromStandardInput) {
  const fs::path input = folder.write("input", "\n" + synthetic_scene(1).string() + "\n\nmixed_objects_1_002");
  expect_frames(stream({"-"}, {.folder = synthetic_scenes(), .standard_input = input}), {all_names[1], all_names[2]},
                0);
}

TEST_F(StreamCommand, ReadsPathsFromANamedPipe) {
  const fs::path pipe = folder.path() / "frames";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::fstream driver(pipe);  // for both directions, which does not wait for a reader
  driver << paths({1, 2}) << std::flush;
  expect_frames(stream({pipe, "--idle", "0.1"}), {all_names[1], all_names[2]}, 0);
}

TEST_F(StreamCommand, PathsInAFileBeginAtItsFolder) {
  fs::copy(synthetic_scenes(), folder.path() / "scenes", fs::copy_options::recursive);
  const fs::path list = folder.write("scenes/list.txt", "mixed_objects_1_001\n");
  expect_frames(stream({list}, {.folder = "/"}), {all_names[1]}, 0);
}

TEST_F(StreamCommand, AListFromWindowsNamesTheSameScenes) {
  std::string lines = "\xEF\xBB\xBF";
  for (const char c : paths({0, 1})) lines += c == '\n' ? "\r\n" : std::string(1, c);
  expect_frames(stream({folder.write("list.txt", lines)}), {all_names[0], all_names[1]}, 0);
}

TEST_F(StreamCommand, AFrameThatFailsDoesNotEndTheStream) {
  const fs::path list = folder.write("list.txt", paths({0}) + "missing_scene\n" + paths({1}));
  const Outcome outcome = stream({list});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(names_of(lines_of(outcome)), (Texts{all_names[0], all_names[1]}));
  EXPECT_EQ(occurrences("gestalt: error: " + (folder.path() / "missing_scene").string() + ": ", outcome.err), 1)
      << outcome.err;
  EXPECT_EQ(occurrences("2 frames, 0 dropped, 1 failed", outcome.err), 1) << outcome.err;
}

TEST_F(StreamCommand, FollowsAFolderTillItIsInterrupted) {
  const fs::path scenes = folder.path() / "scenes";
  fs::create_directories(scenes);
  fs::copy(synthetic_scenes() / "camera.yaml", scenes);
  const auto add = [&](int scene) {
    const fs::path name = synthetic_scene(scene).filename(), unfinished = scenes / ("." + name.string());
    fs::copy(synthetic_scene(scene), unfinished);
    fs::rename(unfinished, scenes / name);
  };
  fs::copy(synthetic_scene(3), scenes / ".unfinished");
  add(2);
  for (const int signal : {SIGINT, SIGTERM}) {
    auto running = std::async(std::launch::async, [&] {
      return stream({scenes, "--follow"}, {.interrupt_after = out / all_names[1] / "result.json", .signal = signal});
    });
    while (!fs::exists(out / all_names[2] / "result.json") &&
           running.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) {
    }
    add(1);
    expect_frames(running.get(), {all_names[2], all_names[1]}, 0);
    fs::remove_all(out);
    fs::remove_all(scenes / all_names[1]);
  }
}

TEST_F(StreamCommand, EndsWhenNoFrameHasComeForSomeTime) {
  expect_frames(stream({synthetic_scenes(), "--follow", "--idle", "0.1"}), all_names, 0);
}

// "scene_1" may be what was written of "scene_10".
TEST_F(StreamCommand, ALineThatIsCutOffIsNoName) {
  const std::string whole = paths({0}), cut = whole + synthetic_scene(1).string();
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  std::thread writer([&] { std::ofstream(pipe) << cut; });
  const Outcome outcome = stream({pipe});
  writer.join();
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(names_of(lines_of(outcome)), Texts{all_names[0]});
  EXPECT_EQ(
      occurrences("pipe:2: the line '" + synthetic_scene(1).string() + "' has no newline at its end", outcome.err), 1)
      << outcome.err;
  expect_frames(stream({folder.write("list", cut)}), {all_names[0], all_names[1]}, 0);
}

TEST_F(StreamCommand, ALineWithANulIsNoName) {
  const fs::path list = folder.write("list", synthetic_scene(0).string() + std::string(1, '\0') + "x\n");
  EXPECT_EQ(stream({list}).code, 3);
}

TEST_F(StreamCommand, NothingToDoIsNoError) {
  const Outcome outcome = stream({folder.write("empty.txt", "")});
  EXPECT_EQ(outcome.code, 0);
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(outcome.err, "gestalt: 0 frames, 0 dropped, 0 failed\n");
}

TEST_F(StreamCommand, RefusesWhatIsNoSource) {
  expect_refused(stream({folder.path() / "missing"}), 3, {"missing: cannot be read", "one path a line"});
  expect_refused(stream({synthetic_scene()}), 3, {"mixed_objects_1_000: is a scene", "gestalt segment"});
  expect_refused(stream({folder.write("list.txt", ""), "--follow"}), 2, {"--follow", "list.txt", "not a folder"});
  const Outcome binary = stream({folder.write("binary", std::string(10000, 'x'))});
  EXPECT_EQ(binary.code, 3);
  EXPECT_GT(occurrences("binary:1: the line is longer", binary.err), 0) << binary.err;
  EXPECT_EQ(stream({synthetic_scenes(), "--drop", "--queue", "2"}).code, 2);
  EXPECT_EQ(stream({synthetic_scenes(), "--queue", "0"}).code, 2);
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(StreamCommand, AFolderWithoutScenesIsRefused) {
  const TemporaryFolder empty;
  const Outcome outcome = run_gestalt({"stream", empty.path(), "--output", empty.path() / "out"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(occurrences(empty.path().string() + ": holds no scene", outcome.err), 1) << outcome.err;
  EXPECT_EQ(occurrences("--follow", outcome.err), 1) << outcome.err;
}

TEST_F(StreamCommand, AFileThatIsNoSceneIsNamed) {
  const TemporaryFolder empty;
  const fs::path list = empty.write("list.txt", "notes.txt\n");
  empty.write("notes.txt", "width: 3\n");
  const Outcome outcome = run_gestalt({"stream", list, "--output", empty.path() / "out"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("notes.txt: is not a scene", outcome.err), 1) << outcome.err;
}

TEST_F(StreamCommand, ObjectsKeepTheirNumbers) {
  const std::vector<json> lines = lines_of(stream({folder.write("list.txt", paths({0, 0})), "--track"}));
  ASSERT_EQ(lines.size(), 2u);
  const json &first = lines[0].at("tracks"), &second = lines[1].at("tracks");
  ASSERT_GT(first.at("objects").size(), 2u);
  EXPECT_EQ(first.at("new").size(), first.at("objects").size());
  EXPECT_EQ(second.at("objects"), first.at("objects"));
  for (const char* event : {"new", "hidden", "lost", "split", "merged"}) EXPECT_TRUE(second.at(event).empty()) << event;
  const json written = json::parse(content(out / all_names[0] / "result.json"));
  EXPECT_EQ(written.at("tracks"), second);
  expect_success(run_gestalt({"info", out / all_names[0] / "result.json"}));
}

TEST_F(StreamCommand, WhatIsNotSeenIsKeptForAsManyFramesAsAskedFor) {
  const fs::path empty = folder.path() / "empty";
  write_scene(empty, small_wall());
  const fs::path list =
      folder.write("list.txt", synthetic_scene(0).string() + "\n" + empty.string() + "\n" + empty.string() + "\n");
  const std::vector<json> lines = lines_of(stream({list, "--track", "--keep", "1"}));
  ASSERT_EQ(lines.size(), 3u);
  const json numbers = lines[0].at("tracks").at("new");
  EXPECT_EQ(lines[1].at("tracks").at("hidden"), numbers);
  EXPECT_EQ(lines[2].at("tracks").at("lost"), numbers);
  EXPECT_TRUE(lines[2].at("tracks").at("hidden").empty());
}

TEST_F(StreamCommand, WithoutTrackThereAreNoTracks) {
  const Outcome outcome = stream({folder.write("list.txt", paths({0}))});
  EXPECT_EQ(occurrences("tracks", outcome.out), 0);
  EXPECT_FALSE(json::parse(content(out / all_names[0] / "result.json")).contains("tracks"));
  EXPECT_EQ(stream({synthetic_scenes(), "--keep", "2"}).code, 2);
  EXPECT_EQ(stream({synthetic_scenes(), "--track", "--keep", "-1"}).code, 2);
}

TEST_F(StreamCommand, PosesAreChecked) {
  const fs::path list = folder.write("list.txt", paths({0}));
  const auto with = [&](const std::string& poses) {
    return stream({list, "--track", "--poses", folder.write("poses.txt", poses)});
  };
  EXPECT_EQ(with("# here\n\n" + all_names[0] + " 0 0 0 0 0 0 1\n").code, 0);
  for (const std::string bad :
       {" 0 0 0 0 0 0", " 0 0 0 0 0 0 1 1", " 0 0 0 0 0 0 2", " 0 0 nan 0 0 0 1", " 0 0 0,1 0 0 0 1"})
    expect_refused(with("# here\n" + all_names[0] + bad + "\n"), 3, {"poses.txt:2: ", "qx qy qz qw"});
  expect_refused(with("a 0 0 0 0 0 0 1\na 0 0 0 0 0 0 1\n"), 3, {"poses.txt:2: ", "'a' has a pose already"});
  expect_refused(with("# none\n"), 3, {"poses.txt: has no pose"});
  expect_refused(stream({list, "--track", "--poses", folder.path() / "missing"}), 3, {"missing: cannot be read"});
  const Outcome other = with("other 0 0 0 0 0 0 1\n");
  EXPECT_EQ(other.code, 1);
  EXPECT_EQ(occurrences("has no pose of the frame '" + all_names[0] + "'", other.err), 1) << other.err;
}

}  // namespace
}  // namespace gestalt::test
