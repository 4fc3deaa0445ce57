// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <nlohmann/json.hpp>
#include <set>
#include <sstream>

#include "gestalt/io/scene/input.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// result.json of a synthetic scene, segmented once with planes and B-splines.
const std::string& stored_result() {
  static const std::string text = [] {
    const TemporaryFolder folder;
    const Outcome outcome =
        run_gestalt({"segment", synthetic_scene(), "--output", folder.path(), "--set", "primitive.fitters.bspline=on"});
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return content(folder.path() / synthetic_scene().filename() / "result.json");
  }();
  return text;
}

class Export : public testing::Test {
 protected:
  Outcome run(const std::string& result, std::vector<std::string> options = {}) const {
    options.insert(options.begin(), {"export", folder.write("result.json", result), "--output", mesh});
    return run_gestalt(options);
  }

  /// Expects that a result with something wrong in it is refused, naming the place.
  void expect_damage_found(const std::function<void(json&)>& damage, const std::vector<std::string>& words) const {
    json result = json::parse(stored_result());
    damage(result);
    std::vector<std::string> all{(folder.path() / "result.json").string(), "gestalt segment"};
    all.insert(all.end(), words.begin(), words.end());
    expect_refused(run(result.dump()), 3, all);
    EXPECT_FALSE(fs::exists(mesh));
  }

  TemporaryFolder folder;
  const fs::path mesh = folder.path() / "mesh";
};

std::size_t patch_of_type(const json& result, const std::string& type) {
  const json& patches = result.at("patches");
  const auto found =
      std::find_if(patches.begin(), patches.end(), [&](const json& p) { return p.at("surface").at("type") == type; });
  EXPECT_NE(found, patches.end()) << type;
  return std::size_t(found - patches.begin());
}

TEST_F(Export, EveryPatchHasAnOutlineAndAnError) {
  const json result = json::parse(stored_result());
  for (const json& patch : result.at("patches")) {
    EXPECT_GE(patch.at("rms"), 0.0);
    EXPECT_LT(patch.at("rms"), 0.05);
    EXPECT_GE(patch.at("outlines").size(), 1u);
    if (patch.at("surface").at("type") == "bspline") {
      for (const json& outline : patch.at("outlines"))
        for (const json& vertex : outline.at("vertices"))
          for (const json& parameter : vertex) {
            EXPECT_GE(parameter, 0.0);
            EXPECT_LE(parameter, 1.0);
          }
    }
  }
}

TEST_F(Export, WritesObjectsWithoutTheBackground) {
  const json result = json::parse(stored_result());
  std::set<int> objects, all;
  for (const json& segment : result.at("segments")) {
    all.insert(segment.at("label").get<int>());
    if (segment.at("role") == "object") objects.insert(segment.at("label").get<int>());
  }
  ASSERT_LT(objects.size(), all.size());
  const auto labels = [&](const std::vector<std::string>& options) {
    expect_success(run(stored_result(), options));
    std::set<int> found;
    const json written = json::parse(content(mesh));
    for (const json& segment : written.at("segments")) found.insert(segment.at("label").get<int>());
    return found;
  };
  EXPECT_EQ(labels({"--format", "json"}), objects);
  EXPECT_EQ(labels({"--format", "json", "--all"}), all);
}

TEST_F(Export, AFolderStandsForItsResult) {
  expect_success(run(stored_result()));
  const std::string of_file = content(mesh);
  expect_success(run_gestalt({"export", folder.path(), "--output", mesh}));
  EXPECT_EQ(content(mesh), of_file);
}

TEST_F(Export, ASegmentWithoutARoleIsAnObject) {
  json result = json::parse(stored_result());
  for (json& segment : result.at("segments")) segment.erase("role");
  expect_success(run(result.dump(), {"--format", "json"}));
  EXPECT_EQ(json::parse(content(mesh)).at("segments").size(), result.at("segments").size());
}

TEST_F(Export, TheMeshIsWhereThePointsAre) {
  expect_success(run(stored_result(), {"--format", "json", "--all"}));
  const Frame frame = read_scene(synthetic_scene()).frame;
  const json written = json::parse(content(mesh));
  int near = 0, vertices = 0;
  for (const json& segment : written.at("segments")) {
    const std::size_t count = segment.at("vertices").size();
    for (const json& triangle : segment.at("triangles"))
      for (const json& vertex : triangle) EXPECT_LT(vertex.get<std::size_t>(), count);
    for (const json& v : segment.at("vertices")) {
      const double x = v.at(0), y = v.at(1), z = v.at(2);
      const int column = int(std::lround(frame.camera.fx * x / z + frame.camera.cx)),
                row = int(std::lround(frame.camera.fy * y / z + frame.camera.cy));
      if (column < 0 || row < 0 || column >= frame.width() || row >= frame.height()) continue;
      ++vertices;
      near += std::abs(frame.depth(row, column) - z) < 0.02;
    }
  }
  EXPECT_GT(vertices, 100);
  EXPECT_GT(near, 0.9 * vertices);
}

TEST_F(Export, TheFormatsHoldTheSameMesh) {
  expect_success(run(stored_result(), {"--format", "json"}));
  std::size_t vertices = 0, triangles = 0;
  const json written = json::parse(content(mesh));
  for (const json& segment : written.at("segments")) {
    vertices += segment.at("vertices").size();
    triangles += segment.at("triangles").size();
  }
  ASSERT_GT(triangles, 0u);
  expect_success(run(stored_result(), {"--format", "obj"}));
  const std::string obj = content(mesh);
  EXPECT_EQ(std::size_t(occurrences("\nv ", obj)), vertices);
  EXPECT_EQ(std::size_t(occurrences("\nf ", obj)), triangles);
  EXPECT_EQ(std::size_t(occurrences("\no segment_", obj)), written.at("segments").size());
  expect_success(run(stored_result(), {"--format", "ply"}));
  const std::string ply = content(mesh);
  EXPECT_EQ(occurrences("element vertex " + std::to_string(vertices) + "\n", ply), 1);
  EXPECT_EQ(occurrences("element face " + std::to_string(triangles) + "\n", ply), 1);
  const std::string body = ply.substr(ply.find("end_header\n") + 11);
  EXPECT_EQ(std::size_t(occurrences("\n", body)), vertices + triangles);
}

TEST_F(Export, TellsStorageAndError) {
  const json result = json::parse(stored_result());
  const Outcome outcome = run(stored_result(), {"--all"});
  expect_success(outcome);
  double points = 0, squares = 0;
  for (const json& patch : result.at("patches")) {
    points += patch.at("pixels").get<double>();
    squares += patch.at("pixels").get<double>() * std::pow(patch.at("rms").get<double>(), 2);
  }
  std::ostringstream rms;
  rms.precision(2);
  rms << std::fixed << 1000 * std::sqrt(squares / points);
  EXPECT_EQ(occurrences("RMS error " + rms.str() + " mm", outcome.out.substr(outcome.out.find("\nall "))), 1)
      << outcome.out;
  EXPECT_EQ(occurrences(std::to_string(12 * std::size_t(points)) + " bytes as points", outcome.out), 1) << outcome.out;
  EXPECT_EQ(occurrences("ratio", outcome.out), int(result.at("segments").size()) + 1);
}

TEST_F(Export, NamesThePlaceOfEveryDamage) {
  const json sound = json::parse(stored_result());
  const std::size_t plane = patch_of_type(sound, "plane"), bspline = patch_of_type(sound, "bspline");
  const std::string at_plane = "patches[" + std::to_string(plane) + "]",
                    at_bspline = "patches[" + std::to_string(bspline) + "]";
  const auto shape = [](json& r, std::size_t patch) -> json& { return r.at("patches").at(patch).at("surface"); };
  expect_damage_found([](json& r) { r.erase("format"); }, {"gestalt-result"});
  expect_damage_found([](json& r) { r["version"] = 1; }, {"version"});
  expect_damage_found([](json& r) { r.erase("patches"); }, {"'patches' is missing"});
  expect_damage_found([](json& r) { r["segments"] = 7; }, {"'segments' must be a list"});
  expect_damage_found([](json& r) { r["segments"][0]["role"] = "table"; }, {"segments[0]", "'table'"});
  expect_damage_found([](json& r) { r["segments"][0]["patches"][0] = 100000; }, {"segments[0]", "'patches'"});
  expect_damage_found([](json& r) { r["segments"][0]["patches"] = {0, 0}; }, {"segments[0]", "patch 0"});
  expect_damage_found([](json& r) { r["segments"][0]["label"] = -1; }, {"segments[0]", "'label'"});
  expect_damage_found([&](json& r) { shape(r, plane)["type"] = "sphere"; }, {at_plane, "'sphere'"});
  expect_damage_found([&](json& r) { shape(r, plane)["centre"] = {0, 1}; }, {at_plane, "centre"});
  expect_damage_found([&](json& r) { shape(r, plane)["across"] = {0, 0, 0}; }, {at_plane, "perpendicular"});
  expect_damage_found([&](json& r) { r["patches"][plane]["pixels"] = -4; }, {at_plane, "'pixels'"});
  expect_damage_found([&](json& r) { r["patches"][plane]["rms"] = "no"; }, {at_plane, "'rms'"});
  expect_damage_found([&](json& r) { r["patches"][plane]["outlines"][0].erase("hole"); },
                      {at_plane, "outlines[0]", "'hole'"});
  expect_damage_found(
      [&](json& r) {
        r["patches"][plane]["outlines"][0]["vertices"][1] = {1e300, 0};
      },
      {at_plane, "outlines[0]", "vertices[1]"});
  expect_damage_found(
      [&](json& r) {
        r["patches"][plane]["outlines"][0]["vertices"] = json(20001, json{0, 0});
      },
      {at_plane, "outlines[0]", "20000"});
  expect_damage_found(
      [&](json& r) {
        r["patches"][bspline]["outlines"][0]["vertices"][0] = {1.5, 0};
      },
      {at_bspline, "vertices[0]", "[-1, 1]"});
  expect_damage_found([&](json& r) { shape(r, bspline)["degree"] = 9; }, {at_bspline, "'degree'"});
  expect_damage_found([&](json& r) { shape(r, bspline)["degree"] = 1; }, {at_bspline, "knots_xi"});
  expect_damage_found([&](json& r) { shape(r, bspline)["knots_xi"][1] = 0.7; }, {at_bspline, "'knots_xi' must ascend"});
  expect_damage_found([&](json& r) { shape(r, bspline)["knots_eta"] = {0, 1}; }, {at_bspline, "'knots_eta'"});
  expect_damage_found([&](json& r) { shape(r, bspline)["knots_eta"] = json(6, 0.5); }, {at_bspline, "'knots_eta'"});
  expect_damage_found([&](json& r) { shape(r, bspline)["control_points"].erase(0); }, {at_bspline, "control_points"});
  expect_damage_found([&](json& r) { shape(r, bspline)["control_points"][1].erase(0); },
                      {at_bspline, "control_points[1]"});
  expect_damage_found([&](json& r) { shape(r, bspline)["control_points"][1][1][2] = nullptr; },
                      {at_bspline, "control_points[1]", "numbers"});
}

TEST_F(Export, RefusesWhatIsNoResult) {
  expect_refused(run(""), 3, {"result.json", "empty"});
  expect_refused(run("{"), 3, {"result.json", "JSON"});
  expect_refused(run(stored_result().substr(0, stored_result().size() / 2)), 3, {"result.json:", "JSON"});
  expect_refused(run("[1, 2]"), 3, {"result.json", "gestalt-result"});
  expect_refused(run("{\"format\": \"gestalt-result\", \"version\": 1e999}"), 3, {"result.json"});
  expect_refused(run_gestalt({"export", folder.path() / "none.json", "--output", mesh}), 3, {"none.json", "not exist"});
  expect_refused(run_gestalt({"export", folder.path(), "--output", mesh}), 3, {"result.json:"});
  EXPECT_FALSE(fs::exists(mesh));
}

TEST_F(Export, RefusesWhatWouldTakeForever) {
  json spiral = json::array();  // out, and back beside itself
  for (int i = 0; i < 10000; ++i)
    spiral.push_back({(1 + 0.004 * i) * std::cos(0.05 * i), (1 + 0.004 * i) * std::sin(0.05 * i)});
  for (int i = 9999; i >= 0; --i)
    spiral.push_back({(1.1 + 0.004 * i) * std::cos(0.05 * i), (1.1 + 0.004 * i) * std::sin(0.05 * i)});
  const std::size_t plane = patch_of_type(json::parse(stored_result()), "plane");
  json result = json::parse(stored_result());
  result["patches"][plane]["outlines"] = {{{"hole", false}, {"vertices", spiral}}};
  expect_refused(run(result.dump(), {"--all"}), 3,
                 {"result.json", "patches[" + std::to_string(plane) + "]", "tangled"});

  result = json::parse(stored_result());
  const std::size_t bspline = patch_of_type(result, "bspline");
  int sign = 1;
  for (json& row : result["patches"][bspline]["surface"]["control_points"])
    for (json& point : row) point[2] = 1e4 * (sign = -sign);
  expect_refused(run(result.dump(), {"--all", "--tolerance", "0.01"}), 3,
                 {"result.json", "patches[" + std::to_string(bspline) + "]", "larger tolerance"});
  EXPECT_FALSE(fs::exists(mesh));
}

TEST_F(Export, TheExtensionTellsTheFormat) {
  const fs::path result = folder.write("result.json", stored_result());
  for (const auto& [name, begin] : {std::pair{"a.obj", "# metres"},
                                    {"a.OBJ", "# metres"},
                                    {"a.json", "{\"format\":"},
                                    {"a.ply", "ply\n"},
                                    {"a", "ply\n"}}) {
    EXPECT_EQ(run_gestalt({"export", result, "--output", folder.path() / name}).code, 0);
    EXPECT_TRUE(content(folder.path() / name).starts_with(begin)) << name;
  }
  EXPECT_EQ(run_gestalt({"export", result, "--output", folder.path() / "b.obj", "--format", "ply"}).code, 0);
  for (const std::string name : {"c.stl", "c.tar.gz", "c.obj.bak"}) {
    expect_refused(run_gestalt({"export", result, "--output", folder.path() / name}), 2, {name, ".ply, .obj or .json"});
    EXPECT_FALSE(fs::exists(folder.path() / name));
    EXPECT_EQ(run_gestalt({"export", result, "--output", folder.path() / name, "--format", "ply"}).code, 0);
  }
  EXPECT_TRUE(content(folder.path() / "b.obj").starts_with("ply\n"));
}

TEST_F(Export, RefusesWrongUsage) {
  EXPECT_EQ(run(stored_result(), {"--format", "stl"}).code, 2);
  EXPECT_EQ(run(stored_result(), {"--tolerance", "0"}).code, 2);
  EXPECT_EQ(run_gestalt({"export", folder.path() / "result.json"}).code, 2);
  expect_refused(run_gestalt({"export", folder.write("result.json", stored_result()), "--output", "/proc/mesh"}), 1,
                 {"/proc/mesh"});
}

}  // namespace
}  // namespace gestalt::test
