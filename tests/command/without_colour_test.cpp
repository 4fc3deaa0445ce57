// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "run_gestalt.h"
#include "scenes.h"

namespace gestalt::test {
namespace {

namespace fs = std::filesystem;

/// The synthetic scenes, of which the first so many have no colour.
class WithoutColour : public testing::Test {
 protected:
  fs::path scenes_without(int count) const {
    fs::path scenes = folder.path() / ("without_" + std::to_string(count));
    fs::copy(synthetic_scenes(), scenes, fs::copy_options::recursive);
    for (int i = 0; i < count; ++i) fs::remove(scenes / synthetic_scene(i).filename() / "rgb.png");
    return scenes;
  }

  static void expect_note(const Outcome& outcome, const std::string& note) {
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(occurrences(note, outcome.err), 1) << outcome.err;
  }

  TemporaryFolder folder;
  const std::string note = "no scene has a colour image; depth alone is used, with depth_only.yaml";
};

TEST_F(WithoutColour, ScenesAreScoredByDepthAlone) {
  const fs::path scenes = scenes_without(4);
  const Outcome outcome = run_gestalt({"evaluate", scenes});
  expect_note(outcome, note + " and its model");
  EXPECT_EQ(outcome.out.substr(0, outcome.out.find('\n')), "depth_only.yaml, 4 images");
  const Outcome asked = run_gestalt({"evaluate", scenes, "--config", "depth_only.yaml"});
  expect_success(asked);
  EXPECT_EQ(asked.out, outcome.out);
  const Outcome folds = run_gestalt({"evaluate", scenes, "--cross-validate", "2"});
  expect_note(folds, note);
  EXPECT_EQ(occurrences("depth_only.yaml, 2-fold", folds.out), 1) << folds.out;
}

TEST_F(WithoutColour, AModelOfDepthAloneIsUsedAsTheNoteTells) {
  const fs::path scenes = scenes_without(4), model = folder.path() / "model.json";
  expect_note(run_gestalt({"train", scenes, "--output", model}),
              note + "; use the model with --config depth_only.yaml");
  expect_success(run_gestalt({"evaluate", scenes, "--config", "depth_only.yaml", "--set", "model=" + model.string(),
                              "--output", folder.path()}));
}

TEST_F(WithoutColour, OneConfigIsForAllScenesOfASet) {
  const fs::path scenes = scenes_without(1), model = folder.path() / "model.json";
  const std::string bare = (scenes / synthetic_scene(0).filename()).string();
  const Texts words{bare + ": has no colour image, as other scenes of the set have", "--config depth_only.yaml"};
  expect_refused(run_gestalt({"train", scenes, "--output", model}), 3, words);
  const Outcome scored = run_gestalt({"evaluate", scenes});
  EXPECT_EQ(scored.code, 1);
  EXPECT_EQ(occurrences("default.yaml, 3 of 4 images", scored.out), 1) << scored.out;
  for (const std::string& word : words) EXPECT_EQ(occurrences(word, scored.err), 1) << scored.err;
  expect_success(run_gestalt({"train", scenes, "--output", model, "--config", "depth_only.yaml"}));
  expect_success(run_gestalt({"evaluate", scenes, "--config", "depth_only.yaml"}));
}

TEST_F(WithoutColour, AConfigThatIsAskedForIsTaken) {
  const fs::path scenes = scenes_without(4);
  for (const Texts& asked : {Texts{"--config", "default.yaml"}, Texts{"--set", "structural.relations.gabor=on"}})
    EXPECT_EQ(run_gestalt(joined({"evaluate", scenes}, asked)).code, 3);
}

TEST_F(WithoutColour, VariantsAreOfTheConfigForDepth) {
  const Outcome outcome =
      run_gestalt({"ablate", scenes_without(4), "--grid", "structural.minimum_size=20,40", "--cross-validate", "2",
                   "--set", "levels=structural", "--output", folder.path() / "ablation"});
  expect_note(outcome, note);
  EXPECT_EQ(occurrences("Ablation of depth_only.yaml", outcome.out), 1) << outcome.out;
}

TEST_F(WithoutColour, AResultIsInspectedWithItsOwnConfig) {
  const fs::path scene = scenes_without(1) / synthetic_scene(0).filename(), out = folder.path() / "out";
  EXPECT_EQ(run_gestalt({"segment", scene, "--output", out}).code, 0);
  expect_success(run_gestalt({"inspect", out / scene.filename(), "--output", folder.path() / "page.html"}));
}

TEST_F(WithoutColour, AStreamTakesEachFrameAsItIs) {
  const Outcome outcome = run_gestalt({"stream", scenes_without(1), "--output", folder.path() / "out"});
  expect_note(outcome, "has no colour image; segmented by depth alone");
  EXPECT_EQ(occurrences("latency_ms", outcome.out), 4) << outcome.out;
}

}  // namespace
}  // namespace gestalt::test
