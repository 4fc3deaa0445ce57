// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The default config with the plugins and the model of this build, on synthetic scenes and on the learn set.

#include "gestalt/core/pipeline/pipeline.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/synthesis/synthesis.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

struct DefaultPipeline {
  explicit DefaultPipeline(const std::vector<std::string>& overrides = {})
      : tree(default_config(), overrides),
        registry(plugin_search_path(tree.plugin_directories())),
        pipeline(tree.resolve(registry), registry) {}
  ConfigTree tree;
  Registry registry;
  Pipeline pipeline;
};

SyntheticScene scene(Category category, int index = 0) { return synthesize(category, 11, index, kinect_camera()); }

/// Everything of a result that must not depend on threads or runs.
struct Outcome {
  cv::Mat_<std::uint16_t> labels;
  nlohmann::json json;
};

Outcome run(const Pipeline& pipeline, const Models& models, const Frame& frame) {
  const Percept percept = pipeline.perceive(frame);
  const Segmentation segmentation = pipeline.decide(percept, models);
  Input input;
  input.frame = frame;
  return {segmentation.labels, result_json(input, percept, segmentation, {}, {})};
}

void expect_equal(const Outcome& x, const Outcome& y) {
  EXPECT_EQ(cv::countNonZero(x.labels != y.labels), 0);
  EXPECT_TRUE(x.json == y.json);
}

TEST(DefaultPipeline, SeparatesStandingBoxesFromTheTable) {
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  std::vector<ImageScore> scores;
  for (int i = 0; i < 4; ++i) {
    const SyntheticScene boxes = scene(Category::boxes, i);
    const Segmentation segmentation = gestalt.pipeline.decide(gestalt.pipeline.perceive(boxes.frame), models);
    scores.push_back(score_image(boxes.ground_truth, segmentation.labels, RegionKind::objects));
  }
  const ScoreRow all = summarise(scores, std::vector<std::string>(scores.size())).back();
  EXPECT_GT(all.pooled.precision(), 0.95);
  EXPECT_GT(all.pooled.recall(), 0.9);
}

TEST(DefaultPipeline, NumbersSegmentsBySizeWithoutGaps) {
  const DefaultPipeline gestalt;
  const Segmentation s = gestalt.pipeline.decide(gestalt.pipeline.perceive(scene(Category::mixed_objects).frame),
                                                 gestalt.pipeline.load_models());
  ASSERT_FALSE(s.segments.empty());
  for (std::size_t i = 0; i < s.segments.size(); ++i) {
    EXPECT_EQ(cv::countNonZero(s.labels == int(i + 1)), s.segments[i].pixel_count);
    EXPECT_TRUE(i == 0 || s.segments[i].pixel_count <= s.segments[i - 1].pixel_count);
  }
}

TEST(DefaultPipeline, GivesTheSameForAnyNumberOfThreads) {
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  for (const Category category : {Category::cylindric_objects, Category::complex_scene}) {
    const Frame frame = scene(category).frame;
    std::vector<Outcome> outcomes;
    for (const std::size_t threads : {1, 8, 8}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      outcomes.push_back(run(gestalt.pipeline, models, frame));
    }
    expect_equal(outcomes[0], outcomes[1]);
    expect_equal(outcomes[0], outcomes[2]);
  }
}

TEST(DefaultPipeline, MayBeUsedFromManyThreadsAtOnce) {
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  const Frame frame = scene(Category::mixed_objects).frame;
  const Outcome alone = run(gestalt.pipeline, models, frame);
  std::vector<std::future<Outcome>> together;
  for (int i = 0; i < 4; ++i)
    together.push_back(std::async(std::launch::async, [&] { return run(gestalt.pipeline, models, frame); }));
  for (auto& outcome : together) expect_equal(alone, outcome.get());
}

TEST(DefaultPipeline, EightAtOnceGiveWhatEachGivesAlone) {
  constexpr int count = 8;
  std::vector<Outcome> alone;
  std::vector<Frame> frames;
  for (int i = 0; i < count; ++i) {
    const DefaultPipeline gestalt;
    frames.push_back(scene(i % 2 ? Category::complex_scene : Category::cylindric_objects, i / 2).frame);
    alone.push_back(run(gestalt.pipeline, gestalt.pipeline.load_models(), frames.back()));
  }
  std::vector<std::future<Outcome>> together;
  for (int i = 0; i < count; ++i)
    together.push_back(std::async(std::launch::async, [&frames, i] {
      const DefaultPipeline gestalt;
      return run(gestalt.pipeline, gestalt.pipeline.load_models(), frames[std::size_t(i)]);
    }));
  for (int i = 0; i < count; ++i) expect_equal(alone[std::size_t(i)], together[std::size_t(i)].get());
}

TEST(DefaultPipeline, EndsAFrameWhoseTimeIsOver) {
  const Frame frame = scene(Category::mixed_objects).frame;
  const DefaultPipeline hasty({"time_budget=1"});
  try {
    hasty.pipeline.perceive(frame);
    FAIL() << "a frame of 640x480 takes longer than a millisecond";
  } catch (const TimeError& error) {
    EXPECT_NE(std::string(error.what()).find("time_budget of 1 ms"), std::string::npos) << error.what();
  }
  const DefaultPipeline patient({"time_budget=60000"}), unlimited;
  const Models models = unlimited.pipeline.load_models();
  expect_equal(run(patient.pipeline, models, frame), run(unlimited.pipeline, models, frame));
}

TEST(DefaultPipeline, CountsTheTimeOfPerceptionToThatOfTheDecision) {
  const DefaultPipeline gestalt({"time_budget=60000"});
  const Models models = gestalt.pipeline.load_models();
  Percept percept = gestalt.pipeline.perceive(scene(Category::boxes).frame);
  EXPECT_NO_THROW(gestalt.pipeline.decide(percept, models));
  percept.times.signal = 60000;
  EXPECT_THROW(gestalt.pipeline.decide(percept, models), TimeError);
}

TEST(DefaultPipeline, FindsNoPairOnASinglePlane) {
  const DefaultPipeline gestalt;
  const auto wall = test::render({{{0, 0, 640, 480}, {0, 0, 1}, {0, 0, -1}}});
  const Percept percept = gestalt.pipeline.perceive(wall.frame);
  EXPECT_EQ(percept.surfaces.surfaces.size(), 1u);
  EXPECT_TRUE(percept.structural.pairs.empty());
  const Segmentation segmentation = gestalt.pipeline.decide(percept, gestalt.pipeline.load_models());
  EXPECT_EQ(segmentation.segments.size(), 1u);
  EXPECT_EQ(segmentation.segments[0].pixel_count, 640 * 480);
}

TEST(DefaultPipeline, WorksOnAnyImageSize) {
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(37, 3), cv::Size(1280, 960)}) {
    const auto frame =
        test::render({{{0, 0, size.width, size.height}, {0, 0, 1}, {0, 0, -1}}}, test::kinect(size.width, size.height))
            .frame;
    const Outcome outcome = run(gestalt.pipeline, models, frame);
    EXPECT_EQ(outcome.labels.size(), size);
    EXPECT_EQ(cv::countNonZero(outcome.labels), size.area());
  }
}

TEST(DefaultPipeline, RefusesAFrameWithoutColourWhenARelationNeedsIt) {
  const DefaultPipeline gestalt;
  Frame frame = scene(Category::boxes).frame;
  frame.colour.release();
  try {
    gestalt.pipeline.perceive(frame);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("colour"), std::string::npos);
  }
  const DefaultPipeline colourless({"assembly.relations.colour_histogram=off",
                                    "structural.relations.colour_histogram=off",
                                    "structural.relations.texture_quantity=off", "structural.relations.gabor=off",
                                    "structural.relations.fourier=off", "structural.relations.border_colour=off"});
  EXPECT_GT(colourless.pipeline.perceive(frame).structural.pairs.size(), 0u);
  EXPECT_THROW(colourless.pipeline.load_models(), ModelError);
}

// A loop that is cancelled ends early without a sign; what the pipeline gives must be complete all the same.
TEST(DefaultPipeline, IsCompleteInAGroupThatIsCancelled) {
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  const Frame frame = scene(Category::mixed_objects).frame;
  const Outcome undisturbed = run(gestalt.pipeline, models, frame);
  tbb::task_group_context group;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        group.cancel_group_execution();
        expect_equal(run(gestalt.pipeline, models, frame), undisturbed);
      },
      group);
}

TEST(DefaultModel, LearntFromRealAndSyntheticScenes) {
  EXPECT_EQ(DefaultPipeline().pipeline.load_models().structural.training.scenes.size(), 45u + 6 * 20);
}

TEST(DefaultModel, FindsTheObjectsOfTheLearnSet) {
  const std::filesystem::path folder = std::filesystem::path(GESTALT_SHARED_DATA) / "osd" / "learn";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the learn set is not at " << folder;
  const DefaultPipeline gestalt;
  const Models models = gestalt.pipeline.load_models();
  std::vector<ImageScore> scores;
  for (const auto& path : find_scenes({folder})) {
    const Input input = read_scene(path);
    const Segmentation segmentation = gestalt.pipeline.decide(gestalt.pipeline.perceive(input.frame), models);
    scores.push_back(score_image(input.ground_truth, segmentation.labels, RegionKind::objects));
  }
  const ScoreRow all = summarise(scores, std::vector<std::string>(scores.size())).back();
  EXPECT_GT(all.pooled.precision(), 0.99);
  EXPECT_GT(all.pooled.recall(), 0.98);
}

}  // namespace
}  // namespace gestalt
