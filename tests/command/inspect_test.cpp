// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>

#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/io/scene/input.h"
#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// The content of the element of an id in a page.
json data_of(const std::string& page, const std::string& id) {
  const std::string begin = "<script type=\"application/json\" id=\"" + id + "\">";
  const std::size_t at = page.find(begin);
  if (at == page.npos) throw std::runtime_error("no " + id);
  const std::size_t first = at + begin.size();
  return json::parse(page.substr(first, page.find("</script>", first) - first));
}

/// Two of the synthetic scenes, segmented once.
const fs::path& results() {
  static const TemporaryFolder folder;
  static const fs::path made = [] {
    expect_success(run_gestalt({"segment", synthetic_scene(0), synthetic_scene(1), "--output", folder.path()}));
    return folder.path();
  }();
  return made;
}

fs::path result_of(int index) { return results() / synthetic_scene(index).filename() / "result.json"; }

class Inspect : public testing::Test {
 protected:
  Outcome run(const Texts& words) const { return run_gestalt(joined({"inspect", "--output", page}, words)); }

  /// A result with something changed.
  fs::path changed(const std::function<void(json&)>& change) const {
    json result = json::parse(content(result_of(0)));
    change(result);
    return folder.write("result.json", result.dump());
  }

  void expect_no_page(const Outcome& outcome, int code, const Texts& words) const {
    expect_refused(outcome, code, words);
    EXPECT_FALSE(fs::exists(page));
  }

  /// The scene in the page, which a run with a warning has made.
  json warned(const Outcome& outcome, const std::string& word) const {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(occurrences("gestalt: warning: ", outcome.err), 1) << outcome.err;
    EXPECT_EQ(occurrences(word, outcome.err), 1) << outcome.err;
    return data_of(content(page), "scene-0");
  }

  TemporaryFolder folder;
  const fs::path page = folder.path() / "page.html";
};

TEST_F(Inspect, ThePageHoldsWhatTheResultSays) {
  const Outcome outcome = run({result_of(0)});
  expect_success(outcome);
  EXPECT_EQ(occurrences(page.string() + ": 1 scene, ", outcome.out), 1) << outcome.out;
  const json scene = data_of(content(page), "scene-0"), result = json::parse(content(result_of(0)));
  EXPECT_EQ(scene.at("name"), result.at("scene"));
  EXPECT_EQ(scene.at("notes"), json::array());
  ASSERT_EQ(scene.at("patches").size(), result.at("patches").size());
  ASSERT_EQ(scene.at("edges").size() + scene.at("edges_left_out").get<std::size_t>(), result.at("pairs").size());
  std::map<std::pair<int, int>, json> pairs;
  for (const json& pair : result.at("pairs")) pairs[{pair.at("a"), pair.at("b")}] = pair;
  for (const json& edge : scene.at("edges")) {
    const json& pair = pairs.at({edge.at(0), edge.at(1)});
    const json& level = scene.at("levels").at(edge.at(2).get<std::size_t>());
    EXPECT_EQ(level.at("name"), pair.at("level"));
    EXPECT_NEAR(edge.at(3).get<double>(), pair.at("p").get<double>(), 5e-5);
    ASSERT_EQ(edge.at(5).size(), level.at("values").size());
    ASSERT_EQ(edge.at(6).size(), level.at("values").size());
    ASSERT_EQ(pair.at("relations").size(), level.at("values").size());
    for (std::size_t i = 0; i < edge.at(5).size(); ++i) {
      const double value = pair.at("relations").at(level.at("values").at(i).at("name").get<std::string>());
      EXPECT_NEAR(edge.at(5).at(i).get<double>(), value, 1e-3 * std::abs(value) + 1e-12);
      EXPECT_LE(std::abs(edge.at(6).at(i).get<double>()), 1.0);
    }
  }
  const json& labels = scene.at("solver").at("cuts").at(0).at("labels");
  for (const json& segment : result.at("segments"))
    for (const json& patch : segment.at("patches")) EXPECT_EQ(labels.at(patch.get<std::size_t>()), segment.at("label"));
}

TEST_F(Inspect, GroundTruthIsThatOfTraining) {
  expect_success(run({results() / synthetic_scene().filename()}));  // the folder will do
  const json scene = data_of(content(page), "scene-0");
  std::size_t known = 0;
  for (const json& edge : scene.at("edges")) {
    const auto object = [&](int end) {
      return scene.at("patches").at(edge.at(std::size_t(end)).get<std::size_t>()).at("object").get<int>();
    };
    const bool unknown = object(0) == 0 || object(1) == 0 || (object(0) == 1 && object(1) == 1);
    EXPECT_EQ(edge.at(4), unknown ? json() : json(int(object(0) == object(1))));
    known += !unknown;
  }
  EXPECT_GT(known, 0u);
}

TEST_F(Inspect, ThePageIsTheSameForAnyNumberOfThreads) {
  expect_success(run({result_of(0), "--threads", "1"}));
  const std::string one = content(page);
  expect_success(run({result_of(0), "--threads", "4"}));
  EXPECT_TRUE(content(page) == one);
}

TEST_F(Inspect, TheSliderHasEveryRealParameterOfTheSolver) {
  const auto sweeps = [&](const std::string& solver) {
    const fs::path out = folder.path() / solver;
    expect_success(run_gestalt({"segment", synthetic_scene(), "--output", out, "--set", "decision.solver=" + solver}));
    expect_success(run({out / synthetic_scene().filename()}));
    const json told = data_of(content(page), "scene-0").at("solver");
    EXPECT_EQ(told.at("plugin"), solver);
    Texts names;
    for (const json& sweep : told.at("sweeps")) {
      names.push_back(sweep.at("name"));
      EXPECT_EQ(sweep.at("values").size(), sweep.at("cuts").size());
      const auto current = std::find(sweep.at("values").begin(), sweep.at("values").end(), sweep.at("current"));
      EXPECT_EQ(sweep.at("cuts").at(std::size_t(current - sweep.at("values").begin())), 0);
      for (const json& cut : sweep.at("cuts")) EXPECT_LT(cut.get<std::size_t>(), told.at("cuts").size());
    }
    return names;
  };
  EXPECT_EQ(sweeps("multicut"), (Texts{"structural_probability", "assembly_probability", "assembly_weight"}));
  EXPECT_EQ(sweeps("group_linkage"), (Texts{"k", "probability"}));
  EXPECT_EQ(sweeps("graph_cut"), (Texts{"k"}));
  EXPECT_EQ(sweeps("threshold"), (Texts{"probability"}));
}

TEST_F(Inspect, SeveralResultsShareAPage) {
  const Outcome outcome = run({result_of(0), result_of(1)});
  expect_success(outcome);
  EXPECT_EQ(occurrences("2 scenes", outcome.out), 1) << outcome.out;
  const std::string text = content(page);
  EXPECT_EQ(data_of(text, "scenes"), (json{"mixed_objects_1_000", "mixed_objects_1_001"}));
  EXPECT_EQ(data_of(text, "scene-1").at("name"), "mixed_objects_1_001");
  EXPECT_NE(data_of(text, "scene-0").at("patches"), data_of(text, "scene-1").at("patches"));
  EXPECT_EQ(occurrences("<img id=\"picture-", text), 2);
}

TEST_F(Inspect, AMovedSceneIsFoundWhereItIsSaidToBe) {
  const fs::path moved = folder.path() / "moved" / "mixed_objects_1_000";
  fs::create_directories(moved.parent_path());
  fs::copy(synthetic_scene(), moved, fs::copy_options::recursive);
  fs::copy(synthetic_scenes() / "camera.yaml", folder.path() / "moved");
  const fs::path lost = changed([&](json& r) { r["input"] = (folder.path() / "gone").string(); });
  expect_no_page(run({lost}), 3, {"result.json", (folder.path() / "gone").string(), "--scene"});
  expect_no_page(run({changed([](json& r) { r.erase("input"); })}), 3, {"result.json", "--scene"});
  expect_no_page(run({lost, "--scene", folder.path() / "gone"}), 3, {"gone", "exist"});
  for (const fs::path& scene : {moved, moved.parent_path(), synthetic_scenes()}) {
    expect_success(run({lost, "--scene", scene}));
    EXPECT_EQ(data_of(content(page), "scene-0").at("notes"), json::array());
    fs::remove(page);
  }
  const fs::path other = changed([&](json& r) { r["scene"] = "elsewhere"; });
  expect_no_page(run({other, "--scene", synthetic_scenes()}), 3, {"'elsewhere'", synthetic_scenes().string()});
}

TEST_F(Inspect, SaysWhereItDisagreesWithTheResult) {
  const json scene = warned(
      run({changed([](json& r) { r["pairs"][3]["p"] = r["pairs"][3]["p"].get<double>() + 0.25; })}), "pairs[3].p");
  ASSERT_EQ(scene.at("notes").size(), 1u);
  EXPECT_EQ(occurrences("pairs[3].p", scene.at("notes").at(0)), 1);
  warned(run({changed([](json& r) { r.erase("segments"); })}), "\"segments\"");
  warned(run({result_of(0), "--scene", synthetic_scene(1)}), "first at scene");
}

TEST_F(Inspect, TakesAnotherConfigWhereItIsAskedTo) {
  const fs::path bare = changed([](json& r) { r.erase("config"); });
  expect_no_page(run({bare}), 3, {"result.json", "config", "--config"});
  expect_success(run({bare, "--config", fs::path(GESTALT_CONFIGS) / "default.yaml"}));
  fs::remove(page);
  expect_no_page(run({changed([](json& r) { r["config"]["values"]["signal"] = 3; })}), 2,
                 {"result.json: config:", "signal"});
  expect_no_page(run({changed([](json& r) { r["config"]["values"]["model"] = "/none.json"; })}), 2, {"/none.json"});
  warned(run({result_of(0), "--set", "decision.solver.params.structural_probability=0.999"}), "segments");
}

TEST_F(Inspect, LoadsNoPluginsFromWhereAResultSays) {
  const std::string plugins = fs::path(BROKEN_PLUGINS) / "old_interface";
  const fs::path result = changed([&](json& r) {
    r["config"]["values"]["plugin_directories"] = {plugins};
    r["config"]["values"]["decision"]["solver"] = "none_such";  // the error tells all folders that were searched
  });
  expect_no_page(run({result}), 2, {"none_such", "searched", "not searched", "untrusted", plugins});
  const std::string searched = run({result}).err;
  EXPECT_EQ(occurrences(plugins, searched.substr(0, searched.find("not searched"))), 0) << searched;
  expect_success(run({changed([&](json& r) { r["config"]["values"]["plugin_directories"] = {plugins}; })}));
}

// What the message advises works as it is written there, but for the shell's quotes.
TEST_F(Inspect, LoadsPluginsFromWhereItsUserSays) {
  const std::string plugins = fs::path(BROKEN_PLUGINS) / "misbehaving";
  const fs::path result = changed([&](json& r) {
    r["config"]["values"]["plugin_directories"] = {plugins};
    r["config"]["values"]["decision"]["solver"] = {{"plugin", "misbehaving"}, {"params", {{"how", "throw"}}}};
  });
  const std::string advised = "plugin_directories=[\"" + plugins + "\"]";
  expect_no_page(run({result}), 2, {"there is no solver 'misbehaving'", "--set '" + advised + "'"});
  expect_no_page(run({result, "--set", advised}), 2, {"solver 'misbehaving' failed: the moon is full"});
}

TEST_F(Inspect, RefusesWhatIsNoResult) {
  expect_no_page(run({folder.path() / "none.json"}), 3, {"none.json", "not exist"});
  expect_no_page(run({folder.path()}), 3, {(folder.path() / "result.json").string(), "not exist"});
  expect_no_page(run({folder.write("result.json", "{")}), 3, {"result.json", "JSON"});
  expect_no_page(run({folder.write("result.json", "[]")}), 3, {"result.json", "gestalt-result"});
  expect_no_page(run({folder.write("result.json", content(result_of(0)).substr(0, 5000))}), 3,
                 {"result.json:", "not valid JSON"});
  expect_no_page(run({changed([](json& r) { r["version"] = 1; })}), 3, {"result.json", "version"});
  expect_no_page(run({result_of(0), folder.path() / "none.json"}), 3, {"none.json"});
}

TEST_F(Inspect, RefusesWrongUsage) {
  EXPECT_EQ(run_gestalt({"inspect"}).code, 2);
  EXPECT_EQ(run_gestalt({"inspect", result_of(0), "--output", ""}).code, 2);
  expect_refused(run_gestalt({"inspect", result_of(0), "--output", "/proc/page.html"}), 1, {"/proc/page.html"});
}

TEST_F(Inspect, AStrangersTextEndsNoElement) {
  const std::string name = "a<b><!--<script>&\"'";
  const fs::path odd = folder.path() / "odd" / name;
  fs::create_directories(odd.parent_path());
  fs::copy(synthetic_scene(), odd, fs::copy_options::recursive);
  fs::copy(synthetic_scenes() / "camera.yaml", folder.path() / "odd");
  expect_success(run_gestalt({"segment", odd, "--output", folder.path() / "out"}));
  expect_success(run({result_of(0)}));
  const int tags = occurrences("<", content(page));
  expect_success(run({folder.path() / "out" / name}));
  EXPECT_EQ(occurrences("<", content(page)), tags);
  EXPECT_EQ(data_of(content(page), "scenes"), json{name});
}

}  // namespace
}  // namespace gestalt::test
