// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Every finished file below a folder with its bytes. A killed run may leave a temporary file, which nothing reads.
std::map<std::string, std::string> contents(const fs::path& folder) {
  std::map<std::string, std::string> files;
  for (const std::string& file : files_below(folder))
    if (file.find(".tmp") == std::string::npos) files[file] = content(folder / file);
  return files;
}

class Ablation : public testing::Test {
 protected:
  Outcome ablate(const Texts& more, const std::string& output = "out", const Surroundings& surroundings = {}) const {
    return run_gestalt(
        joined({"ablate", synthetic_scenes(), "--cross-validate", "2", "--output", folder.path() / output}, more),
        surroundings);
  }
  fs::path out(const std::string& name) const { return folder.path() / "out" / name; }
  const TemporaryFolder folder;
};

TEST_F(Ablation, LinksInTheOutputAreNotFollowed) {
  const fs::path elsewhere = folder.path() / "elsewhere";
  fs::create_directories(elsewhere);
  fs::create_directories(folder.path() / "out");
  fs::create_directory_symlink(elsewhere, out("results"));
  expect_refused(ablate({"--grid", "structural.minimum_size=30"}), 1,
                 {"results: is a symbolic link", "choose another --output"});
  EXPECT_TRUE(fs::is_empty(elsewhere));
  fs::remove(out("results"));
  fs::create_symlink(folder.write("precious", "mine"), out("ablation.csv"));
  expect_success(ablate({"--grid", "structural.minimum_size=30"}));
  EXPECT_EQ(content(folder.path() / "precious"), "mine");
}

TEST_F(Ablation, ScoresOfVariantsAreThoseOfTheirOwnRuns) {
  const Outcome outcome =
      ablate({"--each", "structural.relations", "--grid", "structural.minimum_size=30,90", "--json"});
  expect_success(outcome);
  const json variants = json::parse(outcome.out).at("variants");
  EXPECT_EQ(variants.size(), 12u);
  const auto expect_like = [&](const std::string& name, const Texts& overrides) {
    Texts arguments{"evaluate", synthetic_scenes(), "--cross-validate", "2", "--json"};
    for (const std::string& text : overrides) arguments = joined(arguments, {"--set", text});
    const Outcome own = run_gestalt(arguments);
    expect_success(own);
    const json expected = json::parse(own.out);
    const json& result = variants.at(name);
    EXPECT_EQ(result.at("scores").back().at("precision"), expected.at("all").at("P")) << name;
    EXPECT_EQ(result.at("scores").back().at("recall"), expected.at("all").at("R")) << name;
    EXPECT_EQ(result.at("scores").back().at("overlap_f"), expected.at("all").at("table:oF")) << name;
    EXPECT_EQ(result.at("structural").at("balanced_error"),
              expected.at("held_out_pairs").at("structural").at("balanced_error"))
        << name;
  };
  expect_like("base", {});
  expect_like("without structural.border_curvature", {"structural.relations.border_curvature=off"});
  expect_like("structural.minimum_size=90", {"structural.minimum_size=90"});
}

TEST_F(Ablation, GroundTruthWithoutAnObjectIsRefused) {
  const fs::path scenes = folder.path() / "scenes";
  fs::copy(synthetic_scenes(), scenes, fs::copy_options::recursive);
  for (int i = 0; i < 4; ++i)
    write_image(scenes / synthetic_scene(i).filename() / "label.png",
                cv::Mat_<std::uint8_t>(240, 320, std::uint8_t{1}));
  const Outcome outcome = run_gestalt({"ablate", scenes, "--cross-validate", "2", "--grid",
                                       "structural.minimum_size=20,40", "--output", folder.path() / "out"});
  EXPECT_EQ(outcome.code, 3);
  EXPECT_EQ(occurrences("no scene has an object", outcome.err), 1) << outcome.err;
}

TEST_F(Ablation, WritesTablesAndPlots) {
  folder.write("variants.yaml",
               "forest: structural.classifier=random_forest\nno texture: [structural.relations.gabor=off,"
               " structural.relations.fourier=off]\n");
  const Outcome outcome = ablate({"--variants", folder.path() / "variants.yaml"});
  expect_success(outcome);
  EXPECT_GT(occurrences("2-fold cross-validation over 4 scenes", outcome.out), 0) << outcome.out;
  EXPECT_GT(occurrences("no texture", outcome.out), 0) << outcome.out;
  const std::string table = content(out("ablation.csv"));
  EXPECT_EQ(occurrences("\nbase,", table), 2) << table;  // mixed_objects and all
  EXPECT_EQ(occurrences("\nforest,all,4,", table), 1) << table;
  EXPECT_EQ(occurrences("\n", table), 7) << table;
  const std::string page = content(out("ablation.html"));
  EXPECT_EQ(occurrences("<svg ", page), 4);
  EXPECT_EQ(occurrences("src=", page) + occurrences("href=", page), 0);
  for (const char* plot : {"ablation_pr.svg", "ablation_f.svg", "ablation_error.svg", "ablation_change.svg"}) {
    EXPECT_EQ(occurrences(plot, content(out("ablation.md"))), 1) << plot;
    EXPECT_TRUE(fs::exists(out(plot))) << plot;
  }
}

TEST_F(Ablation, IsEqualForAnyNumberOfThreads) {
  const Texts variants{"--each", "structural.values", "--mode", "only"};
  const Outcome one = ablate(joined(variants, {"--threads", "1"}), "one");
  const Outcome eight = ablate(joined(variants, {"--threads", "8"}), "eight");
  expect_success(one);
  expect_success(eight);
  EXPECT_EQ(one.out, eight.out);
  EXPECT_EQ(contents(folder.path() / "one"), contents(folder.path() / "eight"));
}

TEST_F(Ablation, AKilledRunIsTakenUp) {
  // Variants of different surfaces: much is left to do when the first is finished.
  const Texts variants{"--grid", "primitive.model_selection.kappa_1=0.0011,0.0012,0.0013,0.0014,0.0015", "--threads",
                       "1"};
  const Outcome undisturbed = ablate(variants, "undisturbed");
  expect_success(undisturbed);
  std::vector<fs::path> results;
  for (const auto& entry : fs::directory_iterator(folder.path() / "undisturbed" / "results"))
    results.push_back(entry.path());
  ASSERT_EQ(results.size(), 6u);
  const fs::path first = *std::min_element(results.begin(), results.end(), [](const fs::path& a, const fs::path& b) {
    return fs::last_write_time(a) < fs::last_write_time(b);
  });

  const fs::path first_again = folder.path() / "killed" / "results" / first.filename();
  EXPECT_EQ(ablate(variants, "killed", {.interrupt_after = first_again, .signal = SIGKILL}).code, 128 + SIGKILL);
  const std::size_t finished = contents(folder.path() / "killed").size();
  EXPECT_GE(finished, 1u);
  EXPECT_LT(finished, 6u);
  const auto written = fs::last_write_time(first_again);
  const Outcome resumed = ablate(variants, "killed");
  expect_success(resumed);
  EXPECT_EQ(fs::last_write_time(first_again), written);  // taken, not computed again
  EXPECT_EQ(resumed.out, undisturbed.out);
  EXPECT_EQ(contents(folder.path() / "killed"), contents(folder.path() / "undisturbed"));
}

TEST_F(Ablation, ADamagedResultIsComputedAgain) {
  const Texts variants{"--grid", "structural.minimum_size=30,90"};
  const Outcome before = ablate(variants);
  expect_success(before);
  const auto files = contents(folder.path() / "out");
  EXPECT_EQ(files_below(out("results")).size(), 2u);  // 30 is the default: the same as the base
  const fs::path damaged = out("results") / files_below(out("results")).front();
  truncate(damaged, 0.5);
  const Outcome after = ablate(variants);
  EXPECT_EQ(after.code, 0);
  EXPECT_EQ(occurrences("gestalt: warning: " + damaged.string() + ": is damaged", after.err), 1) << after.err;
  EXPECT_EQ(after.out, before.out);
  EXPECT_EQ(contents(folder.path() / "out"), files);
}

TEST_F(Ablation, OtherScenesAreOtherResults) {
  const Texts grid{"--grid", "structural.minimum_size=60"};
  const Texts few{"ablate", synthetic_scene(0), synthetic_scene(1), synthetic_scene(2), "--output", out("")};
  expect_success(run_gestalt(joined(few, joined(grid, {"--cross-validate", "2"}))));
  EXPECT_EQ(files_below(out("results")).size(), 2u);
  expect_success(run_gestalt(joined(few, joined(grid, {"--cross-validate", "3"}))));
  EXPECT_EQ(files_below(out("results")).size(), 4u);
  expect_success(run_gestalt(joined(few, joined(grid, {"--test", synthetic_scene(3)}))));
  EXPECT_EQ(files_below(out("results")).size(), 6u);
}

TEST_F(Ablation, BadVariantsAreRefusedBeforeAnythingIsRun) {
  const auto refuse = [&](const Texts& arguments, const Texts& words) {
    expect_refused(ablate(arguments), 2, words);
    EXPECT_FALSE(fs::exists(folder.path() / "out"));
  };
  refuse({}, {"nothing to compare", "--each"});
  refuse({"--each", "structural.relation"}, {"did you mean 'structural.relations'"});
  refuse({"--each", "assembly.relations", "--set", "levels=structural"}, {"levels=structural+assembly"});
  refuse({"--grid", "structural.minimum_sise=20,30"}, {"structural.minimum_sise=20", "did you mean 'minimum_size'"});
  refuse({"--grid", "structural.minimum_size=20,many"}, {"variant 'structural.minimum_size=many'"});
  refuse({"--grid", "structural.minimum_size"}, {"path=value"});
  refuse({"--variants", folder.write("v.yaml", "a: [structural.relations.gabour=off]\n")}, {"variant 'a'", "gabor"});
  refuse({"--variants", folder.write("v.yaml", "base: [structural.minimum_size=20]\n")}, {"two variants", "base"});
  refuse({"--each", "structural.values", "--each", "structural.values"}, {"two variants are named"});
  refuse({"--each", "structural.relations", "--seed", "3", "--set", "structural.minimum_size=0"}, {"minimum_size"});
}

TEST_F(Ablation, ScenesMustHaveGroundTruthAndBeApart) {
  const Texts each{"--each", "structural.relations", "--output", folder.path() / "out"};
  const fs::path scene = write_scene(folder.path() / "unlabelled", small_wall());
  expect_refused(run_gestalt(joined({"ablate", synthetic_scenes(), scene}, each)), 3, {scene.string(), "ground truth"});
  expect_refused(run_gestalt(joined({"ablate", synthetic_scenes(), "--test", synthetic_scene()}, each)), 2,
                 {synthetic_scene().string(), "both a training scene and a test scene"});
  expect_refused(run_gestalt(joined({"ablate", synthetic_scenes()}, each)), 2, {"5 folds of 4 scenes"});
  EXPECT_EQ(files_below(folder.path() / "out"), Texts{});
}

class Reproduction : public testing::Test {
 protected:
  Outcome reproduce(const fs::path& data, const Texts& more = {}) const {
    return run_gestalt(joined({"reproduce", data, "--output", out}, more));
  }
  /// Two scenes of each of two categories.
  fs::path make_set(const std::string& name, const std::string& seed) const {
    fs::path set = folder.path() / "data" / name;
    for (const char* category : {"occluded_objects", "boxes"})
      expect_success(run_gestalt({"synthesize", "--category", category, "--seed", seed, "--count", "2", "--width",
                                  "320", "--height", "240", "--output", set}));
    return set;
  }
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "report";
};

TEST_F(Reproduction, OfAFolderOfScenesIsByCrossValidation) {
  const Outcome outcome = reproduce(synthetic_scenes(), {"--cross-validate", "2", "--set", "levels=structural"});
  expect_success(outcome);
  for (const char* text :
       {"2-fold cross-validation over 4 scenes", "Table 1", "Table 2", "Table 4", "Figure 5", "r_cu3", "mixed_objects",
        "More than two points from the paper: ", "The config is not configs/paper.yaml.", "within 3 points"})
    EXPECT_GT(occurrences(text, outcome.out), 0) << text << "\nnot in\n" << outcome.out;
  const std::string page = content(out / "report.md");
  EXPECT_GT(occurrences(" | 92.70 | – | – | 97.12 | – | – | 90.59 | – | – | 97.12 | – | 87.03 | 86.01 |", page), 0)
      << page;
  EXPECT_GT(occurrences("<svg ", content(out / "report.html")), 0);
  EXPECT_TRUE(fs::exists(out / "figure_5_structural.svg"));
  const auto before = contents(out);
  const Outcome again = reproduce(synthetic_scenes(), {"--cross-validate", "2", "--set", "levels=structural"});
  EXPECT_EQ(again.out, outcome.out);
  EXPECT_EQ(contents(out), before);
}

TEST_F(Reproduction, OfLearnAndTestSetWithBothLevels) {
  make_set("learn", "1");
  make_set("test", "2");
  const Texts both{"--set", "levels=structural+assembly",
                   "--set", "assembly.relations.colour_histogram=on",
                   "--set", "assembly.relations.relative_size=on",
                   "--set", "assembly.classifier=svm",
                   "--set", "assembly.minimum_size=30"};
  const Outcome outcome = reproduce(folder.path() / "data", joined(both, {"--json"}));
  EXPECT_EQ(outcome.code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  const json base = result.at("variants").at("structural+assembly");
  EXPECT_EQ(base.at("learn").back().at("images"), 4);
  EXPECT_EQ(base.at("test").back().at("images"), 4);
  EXPECT_EQ(base.at("scores").size(), 3u);  // two categories and all
  EXPECT_GT(base.at("test").back().at("assembly_pairs"), 0);
  EXPECT_EQ(std::int64_t(base.at("objects").size()), base.at("scores").back().at("objects").get<std::int64_t>());
  EXPECT_EQ(result.at("paper").at("table_3").size(), 16u);
  const json& summary = result.at("summary");
  ASSERT_EQ(summary.size(), 4u);  // Tables 2 to 4, and all
  int percentages = 0;
  for (const char* table : {"Table 2", "Table 3", "Table 4"}) {
    percentages += summary.at(table).at("percentages").get<int>();
    EXPECT_LE(summary.at(table).at("within_1"), summary.at(table).at("within_3")) << table;
  }
  EXPECT_GT(percentages, 60);
  EXPECT_EQ(summary.at("all").at("percentages"), percentages);
  const std::string page = content(out / "report.md");
  for (const char* text : {"Table 3", "figure_5_assembly.svg", "r\\_co", "| test boxes |"})
    EXPECT_GT(occurrences(text, page), 0) << text << "\nnot in\n" << page;
}

TEST_F(Reproduction, TakesPeersAndFurtherSets) {
  make_set("learn", "1");
  const fs::path others = make_set("others", "2");
  fs::create_directories(folder.path() / "perfect");
  for (const char* set : {"learn", "others"})
    for (const auto& entry : fs::directory_iterator(folder.path() / "data" / set))
      if (entry.is_directory())
        fs::copy(entry.path() / "label.png", folder.path() / "perfect" / (entry.path().filename().string() + ".png"));
  const Texts options{"--cross-validate",
                      "2",
                      "--set",
                      "levels=structural",
                      "--config",
                      "default.yaml",
                      "--also-test",
                      "others=" + others.string(),
                      "--peer",
                      "perfect=" + (folder.path() / "perfect").string(),
                      "--json"};
  const Outcome outcome = reproduce(folder.path() / "data" / "learn", options);
  expect_success(outcome);
  const json result = json::parse(outcome.out);
  const json base = result.at("variants").at("structural");
  EXPECT_EQ(base.at("scores").back().at("images"), 4);
  ASSERT_EQ(base.at("further").size(), 1u);
  EXPECT_EQ(base.at("further")[0].at("category"), "others");
  EXPECT_EQ(base.at("further")[0].at("images"), 4);
  const json peer = result.at("peers").at("perfect");
  EXPECT_EQ(peer.at("scores").back().at("images"), 4);
  EXPECT_EQ(peer.at("scores").back().at("precision"), 1.0);
  EXPECT_GT(peer.at("further")[0].at("recall"), 0.9);  // parts of an object are labels of their own
  EXPECT_GT(occurrences("| others |", content(out / "report.md")), 0);

  // The row is what a model of all scenes to learn from gives.
  const fs::path model = folder.path() / "model.json";
  expect_success(run_gestalt({"train", folder.path() / "data" / "learn", "--config", "default.yaml", "--set",
                              "levels=structural", "--output", model}));
  const Outcome own = run_gestalt({"evaluate", others, "--config", "default.yaml", "--set", "levels=structural",
                                   "--set", "model=" + model.string(), "--json"});
  expect_success(own);
  EXPECT_EQ(base.at("further")[0].at("precision"), json::parse(own.out).at("all").at("P"));
}

TEST_F(Reproduction, PeersAndFurtherSetsThatCannotBeUsedAreRefused) {
  const fs::path learn = make_set("learn", "1");
  const Texts folds{"--cross-validate", "2", "--set", "levels=structural"};
  const auto refuse = [&](const Texts& options, int code, const Texts& words) {
    expect_refused(reproduce(learn, joined(folds, options)), code, words);
    EXPECT_FALSE(fs::exists(out));
  };
  refuse({"--peer", "LCCP"}, 2, {"--peer LCCP", "NAME=PATH"});
  refuse({"--peer", "LCCP=" + (folder.path() / "nowhere").string()}, 3, {"nowhere", "LCCP"});
  refuse({"--peer", "LCCP=" + folder.path().string()}, 3, {"labels.png", "every scene needs a prediction"});
  refuse({"--also-test", "boxes=" + learn.string()}, 2, {"the name boxes is taken"});
  refuse({"--also-test", "again=" + learn.string()}, 2, {"both a training scene and a test scene"});
  refuse({"--also-test", "gone=" + (folder.path() / "nowhere").string()}, 3, {"nowhere"});
}

TEST_F(Reproduction, WithoutCategoriesCountsAll) {
  fs::create_directories(folder.path() / "data");
  fs::copy(synthetic_scenes(), folder.path() / "data" / "learn",
           fs::copy_options::recursive);  // without the csv beside
  const Outcome outcome =
      reproduce(folder.path() / "data", {"--cross-validate", "2", "--set", "levels=structural", "--json"});
  expect_success(outcome);
  const json scores = json::parse(outcome.out).at("variants").at("structural").at("scores");
  ASSERT_EQ(scores.size(), 1u);
  EXPECT_EQ(scores[0].at("category"), "all");
}

TEST_F(Reproduction, DataThatCannotBeUsedAreRefused) {
  expect_refused(reproduce(folder.path() / "nowhere"), 3, {"nowhere", "does not exist"});
  fs::create_directories(folder.path() / "data" / "test");
  expect_refused(reproduce(folder.path() / "data"), 3, {(folder.path() / "data" / "learn").string(), "test"});
  fs::create_directories(folder.path() / "data" / "learn");
  expect_refused(reproduce(folder.path() / "data"), 3, {"contains no scene"});
  write_scene(folder.path() / "data" / "learn" / "a", small_wall());
  fs::remove_all(folder.path() / "data" / "test");
  expect_refused(reproduce(folder.path() / "data"), 2, {"5 folds of 1 scenes"});
  write_scene(folder.path() / "data" / "learn" / "b", small_wall());
  expect_refused(reproduce(folder.path() / "data", {"--cross-validate", "2"}), 3, {"ground truth"});
  EXPECT_FALSE(fs::exists(out));
}

}  // namespace
}  // namespace gestalt::test
