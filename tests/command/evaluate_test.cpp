// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

/// Two sets: the four synthetic scenes of all tests, of category mixed_objects, and two others.
class Evaluate : public testing::Test {
 protected:
  void SetUp() override { synthesize("complex_scene", 2, others); }

  static void synthesize(const std::string& category, int seed, const fs::path& made) {
    expect_success(run_gestalt({"synthesize", "--category", category, "--seed", std::to_string(seed), "--count", "2",
                                "--width", "320", "--height", "240", "--output", made}));
  }

  /// The rows of a run that must succeed.
  static json scores(const Texts& arguments) {
    const Outcome outcome =
        run_gestalt(joined(joined({"evaluate"}, arguments), {"--json", "--set", "levels=structural"}));
    expect_success(outcome);
    return json::parse(outcome.out);
  }

  /// The row "all" of some scenes by a model of others.
  json scores_of_model(const fs::path& tested, const Texts& learnt) const {
    const fs::path model = folder.path() / "model.json";
    expect_success(run_gestalt(joined({"train", "--set", "levels=structural", "--output", model}, learnt)));
    return scores({tested, "--set", "model=" + model.string()}).at("all");
  }

  const TemporaryFolder folder;
  const fs::path others = folder.path() / "others";
  const Texts both{synthetic_scenes(), others};
};

TEST_F(Evaluate, EachSetIsTestedByAModelOfTheOthers) {
  const json rows = scores(joined(both, {"--leave-one-out", "set", "--set", "model=none"}));
  EXPECT_EQ(rows.at("scenes/mixed_objects"), scores_of_model(synthetic_scenes(), {others}));
  EXPECT_EQ(rows.at("others/complex_scene"), scores_of_model(others, {synthetic_scenes()}));
  EXPECT_EQ(rows.at("all").at("images"), 6);
  EXPECT_EQ(rows.at("mean").at("images"), 6);
  const auto detected = [&](const char* row) { return rows.at(row).at("majority:F>.75").get<double>(); };
  EXPECT_DOUBLE_EQ(detected("mean"), (detected("scenes/mixed_objects") + detected("others/complex_scene")) / 2);
  EXPECT_GT(rows.at("held_out_pairs").at("structural").at("true_positive"), 0);
}

TEST_F(Evaluate, ACategoryIsLeftOutOfEverySetThatHasIt) {
  // Of the second set one scene is of the first's category: no model that has seen it may be tested on the others.
  folder.write("others.csv", "scene,category\ncomplex_scene_2_000,mixed_objects\ncomplex_scene_2_001,complex_scene\n");
  const json rows = scores(joined(both, {"--leave-one-out", "category", "--set", "model=none"}));
  EXPECT_EQ(rows.at("scenes/mixed_objects"), scores_of_model(synthetic_scenes(), {others / "complex_scene_2_001"}));
  EXPECT_EQ(rows.at("others/complex_scene"),
            scores_of_model(others / "complex_scene_2_001", {synthetic_scenes(), others / "complex_scene_2_000"}));
  EXPECT_EQ(rows.at("others/mixed_objects").at("images"), 1);
}

TEST_F(Evaluate, WhatIsAlsoTrainedOnIsInEveryModelAndInNoScore) {
  const fs::path extra = folder.path() / "extra";
  synthesize("boxes", 3, extra);
  const json rows =
      scores(joined(both, {"--leave-one-out", "set", "--also-train", extra.string(), "--set", "model=none"}));
  EXPECT_EQ(rows.at("scenes/mixed_objects"), scores_of_model(synthetic_scenes(), {others, extra}));
  EXPECT_EQ(rows.at("all").at("images"), 6);
}

TEST_F(Evaluate, LeavingOneOutIsEqualForAnyNumberOfThreads) {
  const Texts arguments = joined(both, {"--leave-one-out", "set", "--set", "model=none", "--threads"});
  EXPECT_EQ(scores(joined(arguments, {"1"})), scores(joined(arguments, {"4"})));
}

TEST_F(Evaluate, TheFirstTablesAreObjectsThenPrecisionAndRecall) {
  const fs::path predictions = folder.path() / "predictions";
  fs::copy(synthetic_scenes(), predictions, fs::copy_options::recursive);
  fs::copy(others, predictions, fs::copy_options::recursive | fs::copy_options::skip_existing);
  const Texts truth =
      joined(joined({"evaluate"}, both), {"--predictions", predictions.string(), "--image", "label.png", "--parts"});
  const Outcome outcome = run_gestalt(truth);
  expect_success(outcome);
  const std::string& out = outcome.out;
  EXPECT_EQ(occurrences("label.png scored under the rule majority: every segment", out), 1) << out;
  for (const char* row : {"\nscenes/mixed_objects", "\nothers/complex_scene", "\nmean ", "\nall "})
    EXPECT_EQ(occurrences(row, out), 2) << out;
  EXPECT_LT(out.find("F>.75       oF       bF"), out.find("        P        R")) << out;
  EXPECT_EQ(occurrences("rule table", out), 0) << out;

  const Outcome all = run_gestalt(joined(truth, {"--all", "--rule", "none"}));
  expect_success(all);
  EXPECT_EQ(occurrences("label.png scored under the rule none: no segment", all.out), 1) << all.out;
  for (const char* rule : {"rule table", "rule largest", "rule majority", "parts, mean over images"})
    EXPECT_EQ(occurrences(rule, all.out), 1) << all.out;
}

TEST_F(Evaluate, TheRuleSuitsTheImage) {
  const auto scored = [&](const Texts& options) {
    return scores(joined({synthetic_scenes(), "--cross-validate", "2", "--set", "model=none"}, options)).at("scored");
  };
  EXPECT_EQ(scored({}), json({{"image", "labels.png"}, {"regions", "objects"}, {"rule", "majority"}}));
  EXPECT_EQ(scored({"--image", "objects.png"}).at("rule"), "none");
  EXPECT_EQ(scored({"--image", "objects.png", "--rule", "table"}).at("rule"), "table");
}

TEST_F(Evaluate, WhatCannotBeLeftOutIsToldWithTheRemedy) {
  const std::string scenes = synthetic_scenes();
  const auto refuse = [&](const Texts& options, const Texts& words) {
    expect_refused(run_gestalt(joined({"evaluate", scenes}, options)), 2, words);
  };
  refuse({"--leave-one-out", "set"}, {"all scenes belong to one set, scenes", "two folders"});
  refuse({"--leave-one-out", "category"}, {"one category, mixed_objects", scenes + ".csv"});
  refuse({"--also-train", others}, {"--also-train", "nothing is trained", "--leave-one-out"});
  refuse({"--cross-validate", "2", "--also-train", synthetic_scene()},
         {synthetic_scene(), "test scene and a training scene"});
}

TEST_F(Evaluate, LabelsAreNotWrittenAmongResults) {
  expect_success(run_gestalt({"segment", synthetic_scene(), "--output", folder.path()}));
  expect_refused(run_gestalt({"evaluate", synthetic_scene(), "--output", folder.path()}), 2,
                 {"result.json", "choose another --output"});
}

}  // namespace
}  // namespace gestalt::test
