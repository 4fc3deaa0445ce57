// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

class Learning : public testing::Test {
 protected:
  TemporaryFolder folder;
  const fs::path model = folder.path() / "model.json";
};

TEST_F(Learning, TrainReportsPairsAndScaling) {
  const Outcome outcome = run_gestalt({"train", synthetic_scenes(), "--output", model});
  expect_success(outcome);
  const json training = json::parse(content(model)).at("levels").at("structural").at("training");
  EXPECT_GT(training.at("positive_pairs"), 0);
  EXPECT_GT(training.at("negative_pairs"), 0);
  EXPECT_EQ(training.at("scenes").size(), 4u);
  EXPECT_GT(occurrences(training.at("positive_pairs").dump() + " positive and " + training.at("negative_pairs").dump() +
                            " negative pairs",
                        outcome.out),
            0)
      << outcome.out;
  for (const char* name : {"r_co ", "r_rs ", "r_vd2 "}) EXPECT_GT(occurrences(name, outcome.out), 0) << outcome.out;
}

TEST_F(Learning, TrainingIsEqualForAnyNumberOfThreads) {
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model, "--threads", "1"}));
  const std::string one = content(model);
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model, "--threads", "8"}));
  EXPECT_EQ(content(model), one);
}

TEST_F(Learning, TheScoreOfAModelIsThatOfItsLabelImages) {
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model}));
  const std::string setting = "model=" + model.string();
  expect_success(run_gestalt({"segment", synthetic_scenes(), "--set", setting, "--output", folder.path() / "out"}));
  const Outcome direct = run_gestalt({"evaluate", synthetic_scenes(), "--set", setting, "--json"});
  const Outcome predictions =
      run_gestalt({"evaluate", synthetic_scenes(), "--predictions", folder.path() / "out", "--json"});
  expect_success(direct);
  expect_success(predictions);
  EXPECT_EQ(json::parse(direct.out), json::parse(predictions.out));
  // synthesize names the category beside the folder.
  const json all = json::parse(direct.out).at("all");
  EXPECT_EQ(all, json::parse(direct.out).at("mixed_objects"));
  EXPECT_EQ(all.at("images"), 4);
  EXPECT_GT(all.at("P"), 0.8);
  EXPECT_GT(all.at("R"), 0.8);
}

TEST_F(Learning, TheGroundTruthScoresFull) {
  const Outcome outcome = run_gestalt({"evaluate", synthetic_scenes(), "--predictions", synthetic_scenes(), "--image",
                                       "label.png", "--parts", "--json"});
  expect_success(outcome);
  const json all = json::parse(outcome.out).at("all");
  EXPECT_EQ(all.at("P"), 1.0);
  EXPECT_EQ(all.at("R"), 1.0);
}

TEST_F(Learning, CrossValidationNeedsNoModel) {
  const std::vector<std::string> arguments{"evaluate", synthetic_scenes(), "--cross-validate", "2",
                                           "--set",    "model=none"};
  const Outcome table = run_gestalt(arguments);
  expect_success(table);
  EXPECT_GT(occurrences("2-fold cross-validation, 4 images", table.out), 0) << table.out;
  EXPECT_GT(occurrences("mixed_objects", table.out), 0) << table.out;
  auto with_json = arguments;
  with_json.push_back("--json");
  const Outcome first = run_gestalt(with_json);
  with_json.insert(with_json.end(), {"--threads", "1"});
  const Outcome second = run_gestalt(with_json);
  expect_success(first);
  EXPECT_EQ(first.out, second.out);
  EXPECT_EQ(json::parse(first.out).at("all").at("images"), 4);
  EXPECT_GT(json::parse(first.out).at("held_out_pairs").at("structural").at("true_positive"), 0);
}

TEST_F(Learning, TheObjectImageIsScoredAsItIsWritten) {
  const fs::path out = folder.path() / "held_out";
  const Texts scored{"evaluate", synthetic_scenes(), "--image", "objects.png", "--json"};
  const Outcome held_out =
      run_gestalt(joined(scored, {"--cross-validate", "2", "--set", "model=none", "--output", out.string()}));
  expect_success(held_out);
  const Outcome files = run_gestalt(joined(scored, {"--predictions", out.string()}));
  expect_success(files);
  const json all = json::parse(held_out.out).at("all");
  EXPECT_EQ(all, json::parse(files.out).at("all"));
  EXPECT_GT(all.at("none:oF"), 0.5) << "background is 0, so that nothing needs to be dropped";
  const std::string diagram = content(out / "reliability.svg");
  EXPECT_EQ(occurrences("predicted probability", diagram), 1);
  EXPECT_GE(occurrences("<circle", diagram), 2);
  expect_refused(run_gestalt({"evaluate", synthetic_scenes(), "--image", "depth.png"}), 2,
                 {"--image depth.png", "labels.png or objects.png"});
}

TEST_F(Learning, TheClassifierIsAConfigLine) {
  const std::string svm = "structural.classifier=svm";
  // What the error of the installed model suggests is what follows.
  expect_refused(run_gestalt({"segment", synthetic_scene(), "--set", svm, "--output", folder.path() / "out"}), 2,
                 {"`gestalt train SCENES --set " + svm + " --output mine.json`", "--set model=mine.json"});
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model, "--set", svm}));
  const std::string setting = "model=" + model.string();
  expect_success(run_gestalt({"evaluate", synthetic_scenes(), "--set", svm, "--set", setting, "--json"}));
  expect_refused(run_gestalt({"evaluate", synthetic_scenes(), "--set", setting}), 2,
                 {model.string(), "svm", "random_forest"});
}

TEST_F(Learning, AnAblatedRelationNeedsAModelOfItsOwn) {
  const std::string ablation = "structural.relations.gabor=off";
  const fs::path out = folder.path() / "out";
  expect_refused(run_gestalt({"segment", synthetic_scene(), "--set", ablation, "--output", out}), 2,
                 {"default.json", "the config lacks r_ga", "gestalt train"});
  EXPECT_FALSE(fs::exists(out));
  expect_success(run_gestalt({"train", synthetic_scenes(), "--output", model, "--set", ablation}));
  expect_success(run_gestalt(
      {"segment", synthetic_scene(), "--set", ablation, "--set", "model=" + model.string(), "--output", out}));
  expect_refused(run_gestalt({"segment", synthetic_scene(), "--set", "model=" + model.string(), "--output",
                              folder.path() / "other"}),
                 2, {model.string(), "the model lacks r_ga"});
  EXPECT_FALSE(fs::exists(folder.path() / "other"));
}

TEST_F(Learning, TrainingNeedsGroundTruthOfEveryScene) {
  const fs::path scene = write_scene(folder.path() / "unlabelled", small_wall());
  expect_refused(run_gestalt({"train", synthetic_scenes(), scene, "--output", model}), 3,
                 {scene.string(), "label.png"});
  EXPECT_FALSE(fs::exists(model));
}

TEST_F(Learning, TrainingNeedsPairsOfBothClasses) {
  const fs::path scene = write_scene(folder.path() / "wall", small_wall());
  write_image(scene / "label.png", cv::Mat(small_height, small_width, CV_8UC1, cv::Scalar(1)));
  expect_refused(run_gestalt({"train", scene, "--output", model}), 3, {"no scene has an object", "--labels objects"});
  write_image(scene / "label.png", cv::Mat(small_height, small_width, CV_8UC1, cv::Scalar(20)));
  expect_refused(run_gestalt({"train", scene, "--output", model}), 2, {"pairs of both classes", "more scenes"});
  EXPECT_FALSE(fs::exists(model));
}

TEST_F(Learning, AModelReplacesNeitherAFolderNorADevice) {
  fs::create_directory(model);
  expect_refused(run_gestalt({"train", synthetic_scene(), "--output", model}), 1, {model.string(), "folder"});
  const fs::path pipe = folder.path() / "pipe";
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  expect_refused(run_gestalt({"train", synthetic_scene(), "--output", pipe}), 1, {pipe.string(), "not a regular file"});
  EXPECT_TRUE(fs::is_fifo(pipe));
  EXPECT_EQ(files_below(folder.path()), std::vector<std::string>{});
}

TEST_F(Learning, AModelGoesToTheFileBehindALink) {
  folder.write("real.json", "old");
  fs::create_symlink("real.json", model);
  expect_success(run_gestalt({"train", synthetic_scene(), "--output", model}));
  EXPECT_TRUE(fs::is_symlink(model));
  EXPECT_EQ(json::parse(content(folder.path() / "real.json")).at("format"), "gestalt-model");
}

TEST_F(Learning, EvaluationNamesTheSceneThatItCannotScore) {
  const fs::path scene = write_scene(folder.path() / "unlabelled", small_wall());
  const Outcome outcome = run_gestalt({"evaluate", synthetic_scene(), scene, "--json"});
  EXPECT_EQ(outcome.code, 1);
  EXPECT_EQ(occurrences("gestalt: error: " + scene.string(), outcome.err), 1) << outcome.err;
  EXPECT_EQ(json::parse(outcome.out).at("all").at("images"), 1);
  expect_refused(run_gestalt({"evaluate", scene}), 3, {scene.string(), "ground truth"});
}

TEST_F(Learning, EvaluationNamesAMissingPrediction) {
  expect_refused(run_gestalt({"evaluate", synthetic_scene(), "--predictions", folder.path()}), 3,
                 {(folder.path() / "mixed_objects_1_000" / "labels.png").string(), "missing"});
  expect_refused(run_gestalt({"evaluate", synthetic_scene(), "--predictions", folder.path() / "nowhere"}), 3,
                 {(folder.path() / "nowhere").string(), "folder"});
}

TEST_F(Learning, ThereCannotBeMoreFoldsThanScenes) {
  expect_refused(run_gestalt({"evaluate", synthetic_scenes(), "--cross-validate", "5"}), 2, {"5 folds of 4 scenes"});
}

}  // namespace
}  // namespace gestalt::test
