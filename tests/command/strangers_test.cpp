// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// Files that are made to crash the command, to hang it, or to fill memory and disk.

#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Strangers : public testing::Test {
 protected:
  Outcome segment(const fs::path& model) const {
    return run_gestalt({"segment", scene, "--output", out, "--set", "model=" + model.string()});
  }

  TemporaryFolder folder;
  const fs::path scene = write_scene(folder.path() / "scene", small_wall()), out = folder.path() / "out";
};

TEST_F(Strangers, JsonThatIsDeepIsRefused) {
  const std::string deep = std::string(200'000, '[') + std::string(200'000, ']');
  const fs::path model =
      folder.write("m.json", R"({"format":"gestalt-model","version":2,"levels":{"other":)" + deep + "}}");
  const fs::path result = folder.write(
      "r.json", R"({"format":"gestalt-result","version":2,"segments":[],"patches":[],"camera":)" + deep + "}");
  folder.write("bop/scene_camera.json", R"({"0":{"cam_K":)" + deep + "}}");
  const std::string why = "more than 200 nested levels";
  expect_refused(segment(model), 2, {"m.json: levels.other[0]", why});
  expect_refused(run_gestalt({"info", model}), 3, {"m.json: levels.other", why});
  expect_refused(run_gestalt({"info", result}), 3, {"r.json: camera[0]", why});
  expect_refused(run_gestalt({"export", result, "--output", out}), 3, {"r.json: camera[0]", why});
  expect_refused(run_gestalt({"inspect", result, "--output", out}), 3, {"r.json: camera[0]", why});
  expect_refused(run_gestalt({"convert", folder.path() / "bop", "--from", "bop", "--output", out}), 3,
                 {"scene_camera.json: 0.cam_K[0]", why});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Strangers, AForestThatIsOneChainTakenManyTimesIsRefused) {
  const fs::path trained = folder.path() / "trained.json";
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", trained}));
  json model = json::parse(content(trained));
  constexpr std::size_t nodes = 10000;
  std::vector<int> variables(nodes, 0), rights(nodes, int(nodes) + 1), roots(nodes, 0);
  std::vector<double> values(nodes, 9);
  for (int leaf = 0; leaf < 2; ++leaf) variables.push_back(-1), rights.push_back(0), values.push_back(0.5);
  for (json& level : model["levels"])
    level["state"] = {{"roots", roots}, {"variables", variables}, {"rights", rights}, {"values", values}};
  expect_refused(segment(folder.write("m.json", model.dump())), 2, {"m.json", "'roots' must name at most 2000 trees"});
}

// Many small patches cost no more than one large one.
TEST_F(Strangers, AMeshHasAsManyTrianglesAsOneFileMayHave) {
  json control_points = json::array(), knots{0, 0, 0, 0}, outline = json::array();
  for (int i = 1; i < 9; ++i) knots.push_back(i / 9.0);
  for (int i = 0; i < 4; ++i) knots.push_back(1);
  for (int i = 0; i < 12; ++i) {
    control_points.push_back(json::array());
    for (int j = 0; j < 12; ++j) control_points.back().push_back({50.0 * j, 50.0 * i, (i + j) % 2 ? 1000 : -1000});
  }
  for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}}) outline.push_back({x, y});
  const json patch{{"pixels", 9},
                   {"rms", 0.001},
                   {"surface",
                    {{"type", "bspline"},
                     {"degree", 3},
                     {"knots_xi", knots},
                     {"knots_eta", knots},
                     {"control_points", control_points}}},
                   {"outlines", {{{"hole", false}, {"vertices", outline}}}}};
  json result{{"format", "gestalt-result"},
              {"version", 2},
              {"scene", "x"},
              {"patches", json::array()},
              {"segments", json::array()}};
  for (int i = 0; i < 20; ++i) {
    result["patches"].push_back(patch);
    result["segments"].push_back({{"label", i + 1}, {"patches", {i}}});
  }
  expect_refused(run_gestalt({"export", folder.write("r.json", result.dump()), "--output", out}), 3,
                 {"r.json: patches[", "more than 1000000 triangles", "larger tolerance"});
  EXPECT_FALSE(fs::exists(out));
}

TEST_F(Strangers, ControlCharactersOfNamesDoNotReachTheTerminal) {
  const Outcome outcome = run_gestalt({"segment", folder.path() / "a\x1b[31m\x07\xc2\x9b"
                                                                  "2J\x7f gr\xc3\xbcn"});
  expect_refused(outcome, 3, {"a\\x1b[31m\\x07\\x9b2J\\x7f gr\xc3\xbcn: does not exist"});
}

TEST_F(Strangers, ASceneThatCannotBeSeenIsNotLeftOut) {
  const fs::path scenes = folder.path() / "scenes";
  write_scene(scenes / "a", small_wall());
  fs::create_directory_symlink(folder.path() / "nowhere", scenes / "b");
  const Outcome outcome = run_gestalt({"segment", scenes, "--output", out});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("scenes/b: ", outcome.err), 1) << outcome.err;
  EXPECT_TRUE(fs::exists(out / "a" / "result.json"));
  if (::geteuid() == 0) GTEST_SKIP() << "root can read every folder";
  fs::remove(scenes / "b");
  fs::create_directory(scenes / "b");
  fs::permissions(scenes / "b", fs::perms::none);
  EXPECT_EQ(run_gestalt({"segment", scenes, "--output", out}).code, 1);
}

// A sanitizer takes terabytes of address space.
#ifndef GESTALT_UNDER_SANITIZER
TEST_F(Strangers, TooLittleMemoryIsToldWithTheFile) {
  std::string numbers = "[0";
  for (int i = 0; i < 20'000'000; ++i) numbers += ",0";
  const fs::path result = folder.write("r.json", numbers + "]");
  expect_refused(run_gestalt({"info", result}, {.memory = std::size_t{400} << 20}), 3,
                 {"r.json: its 40000003 bytes take more memory than this process may use", "raise its memory limit"});
}
#endif

// Opening a pipe waits for its writer.
TEST_F(Strangers, APipeInPlaceOfGroundTruthIsNotWaitedFor) {
  for (const char* name : {"label.png", "masks/1.png", "coco.json"}) {
    const fs::path truth = scene / name;
    fs::create_directories(truth.parent_path());
    ASSERT_EQ(::mkfifo(truth.c_str(), 0600), 0);
    const Outcome outcome = run_gestalt({"segment", scene, "--output", out});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_GT(occurrences(std::string(name) + ": is not a regular file", outcome.err), 0) << outcome.err;
    EXPECT_EQ(run_gestalt({"evaluate", scene}).code, 3);
    fs::remove_all(truth.parent_path() == scene ? truth : truth.parent_path());
  }
}

TEST_F(Strangers, AnImageThatIsALinkToItselfIsRefused) {
  const fs::path recording = folder.path() / "recording";
  for (const char* part : {"depth", "rgb"}) fs::create_directories(recording / part);
  fs::create_symlink("1.png", recording / "depth" / "1.png");
  fs::create_symlink("nowhere", recording / "link");
  expect_refused(run_gestalt({"convert", recording, "--output", out}), 3, {recording.string()});
  expect_refused(run_gestalt({"segment", recording, "--output", out}), 3, {recording.string()});
}

}  // namespace
}  // namespace gestalt::test
