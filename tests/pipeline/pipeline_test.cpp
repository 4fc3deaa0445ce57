// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// The default config with the plugins and the model of this build, on synthetic scenes and on the learn set.

#include "gestalt/core/pipeline/segmenter.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <future>
#include <nlohmann/json.hpp>
#include <thread>

#include "gestalt/core/base/error.h"
#include "gestalt/core/pipeline/learning_set.h"
#include "gestalt/evaluation/score/evaluation.h"
#include "gestalt/io/result/result.h"
#include "gestalt/io/scene/input.h"
#include "gestalt/synthesis/synthesis.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

SyntheticScene scene(Category category, int index = 0) { return synthesize(category, 11, index, kinect_camera()); }

/// Everything of a result that must not depend on threads or runs.
struct Outcome {
  cv::Mat_<std::uint16_t> labels;
  nlohmann::json json;
};

Outcome run(const Segmenter& segmenter, const Frame& frame) {
  SegmentedFrame found = segmenter.segment(frame);
  found.times = {};
  Input input;
  input.frame = frame;
  return {found.segmentation.labels, result_json(input, found, {})};
}

void expect_equal(const Outcome& x, const Outcome& y) {
  EXPECT_EQ(cv::countNonZero(x.labels != y.labels), 0);
  EXPECT_TRUE(x.json == y.json);
}

TEST(DefaultSegmenter, SeparatesStandingBoxesFromTheTable) {
  const Segmenter gestalt;
  std::vector<ImageScore> scores;
  for (int i = 0; i < 4; ++i) {
    const SyntheticScene boxes = scene(Category::boxes, i);
    const Segmentation segmentation = gestalt.segment(boxes.frame).segmentation;
    scores.push_back(score_image(boxes.ground_truth, segmentation.labels, RegionKind::objects));
  }
  const ScoreRow all = summarise(scores, std::vector<std::string>(scores.size())).back();
  EXPECT_GT(all.precision, 0.95);
  EXPECT_GT(all.recall, 0.9);
}

TEST(DefaultSegmenter, NumbersSegmentsBySizeWithoutGaps) {
  const Segmenter gestalt;
  const Segmentation s = gestalt.segment(scene(Category::mixed_objects).frame).segmentation;
  ASSERT_FALSE(s.segments.empty());
  for (std::size_t i = 0; i < s.segments.size(); ++i) {
    EXPECT_EQ(cv::countNonZero(s.labels == int(i + 1)), s.segments[i].pixel_count);
    EXPECT_TRUE(i == 0 || s.segments[i].pixel_count <= s.segments[i - 1].pixel_count);
  }
}

TEST(DefaultSegmenter, GivesTheSameForAnyNumberOfThreads) {
  const Segmenter gestalt;
  for (const Category category : {Category::cylindric_objects, Category::complex_scene}) {
    const Frame frame = scene(category).frame;
    std::vector<Outcome> outcomes;
    for (const std::size_t threads : {1, 8, 8}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      outcomes.push_back(run(gestalt, frame));
    }
    expect_equal(outcomes[0], outcomes[1]);
    expect_equal(outcomes[0], outcomes[2]);
  }
}

TEST(DefaultSegmenter, EdgesKnowTheirRowOfTheRelationTable) {
  const SegmentedFrame found = Segmenter().segment(scene(Category::mixed_objects).frame);
  std::size_t structural = 0, assembly = 0;
  for (const Edge& edge : found.segmentation.graph.edges) {
    const RelationTable::Pair& pair = found.percept.table(edge.level).pairs.at(edge.row);
    EXPECT_EQ(std::pair(pair.a, pair.b), std::pair(edge.a, edge.b));
    EXPECT_EQ(found.percept.values(edge).size(), found.percept.table(edge.level).names.size());
    ++(edge.level == Level::structural ? structural : assembly);
  }
  EXPECT_GT(structural, 0u);
  EXPECT_GT(assembly, 0u);
}

TEST(DefaultSegmenter, MayBeUsedFromManyThreadsAtOnce) {
  const Segmenter gestalt;
  const Frame frame = scene(Category::mixed_objects).frame;
  const Outcome alone = run(gestalt, frame);
  std::vector<std::future<Outcome>> together;
  for (int i = 0; i < 4; ++i) together.push_back(std::async(std::launch::async, [&] { return run(gestalt, frame); }));
  for (auto& outcome : together) expect_equal(alone, outcome.get());
}

TEST(DefaultSegmenter, EightAtOnceGiveWhatEachGivesAlone) {
  constexpr int count = 8;
  std::vector<Outcome> alone;
  std::vector<Frame> frames;
  for (int i = 0; i < count; ++i) {
    const Segmenter gestalt;
    frames.push_back(scene(i % 2 ? Category::complex_scene : Category::cylindric_objects, i / 2).frame);
    alone.push_back(run(gestalt, frames.back()));
  }
  std::vector<std::future<Outcome>> together;
  for (int i = 0; i < count; ++i)
    together.push_back(std::async(std::launch::async, [&frames, i] {
      const Segmenter gestalt;
      return run(gestalt, frames[std::size_t(i)]);
    }));
  for (int i = 0; i < count; ++i) expect_equal(alone[std::size_t(i)], together[std::size_t(i)].get());
}

constexpr int hour = 3'600'000;  // milliseconds: more than any machine needs for a frame

/// Looks at no clock itself.
struct Sleeper final : Clusterer {
  PatchMap cluster(const Frame& frame) const override {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    return {cv::Mat_<int>(frame.depth.size(), 0), cv::Mat_<cv::Vec3f>(frame.depth.size(), {0, 0, -1}), 0};
  }
};

TEST(DefaultSegmenter, EndsAFrameWhoseTimeIsOver) {
  Registry registry(plugin_search_path({}));
  registry.add<Clusterer>({"clusterer", "sleeper", "1.0.0", "Sleeps longer than a frame may take", {}},
                          {{}, [](const ParameterValues&) { return std::make_unique<Sleeper>(); }});
  const LoadedConfig loaded(ConfigTree(default_config(), {"time_budget=1", "signal.clusterer=sleeper"}),
                            std::move(registry));
  try {
    Pipeline(loaded.config, loaded.registry).perceive(scene(Category::mixed_objects).frame);
    FAIL() << "the clusterer slept for longer than a frame may take";
  } catch (const TimeError& error) {
    EXPECT_NE(std::string(error.what()).find("time_budget of 1 ms"), std::string::npos) << error.what();
  }
}

/// Takes longer than a frame may. A frame comes to its relations within the budget on slow machines, too.
struct SlowRelation final : Relation {
  static constexpr std::chrono::milliseconds budget{6000};
  const std::vector<RelationValue>& values() const override {
    static const std::vector<RelationValue> values{{"r_slow", 0, 1, "0"}};
    return values;
  }
  std::unique_ptr<Measure> bind(const Scene&) const override {
    struct Zero final : Measure {
      void operator()(const SurfacePair&, std::span<double> out) const override { out[0] = 0; }
    };
    std::this_thread::sleep_for(budget + std::chrono::milliseconds(200));
    return std::make_unique<Zero>();
  }
};

TEST(DefaultSegmenter, DecidesALateFrameByWhatIsKnownWhereTheConfigSaysSo) {
  const auto percept_with = [](const std::string& on_timeout) {
    Registry registry(plugin_search_path({}));
    registry.add<Relation>({"relation", "slow", "1.0.0", "Sleeps longer than a frame may take", {}},
                           {{}, [](const ParameterValues&) { return std::make_unique<SlowRelation>(); }});
    const LoadedConfig loaded(
        ConfigTree(default_config(), {"time_budget=" + std::to_string(SlowRelation::budget.count()),
                                      "on_timeout=" + on_timeout, "assembly.relations.slow=on"}),
        std::move(registry));
    return Pipeline(loaded.config, loaded.registry).perceive(scene(Category::boxes).frame);
  };
  EXPECT_THROW(percept_with("error"), TimeError);
  const Percept percept = percept_with("coarse");
  EXPECT_EQ(percept.left_out, Level::structural) << "relations are bound for both levels at once";
  EXPECT_TRUE(percept.structural.pairs.empty());
  EXPECT_FALSE(percept.surfaces().surfaces.empty());
  const Segmenter gestalt(default_config(), {"on_timeout=coarse"});  // within a minute
  EXPECT_GT(gestalt.pipeline().decide(percept, gestalt.models()).segments.size(), 1u);
  EXPECT_FALSE(gestalt.segment(scene(Category::boxes).frame).percept.left_out) << "in time";
}

TEST(DefaultSegmenter, GivesLabelsOfTheFrameWhereItWorksOnLess) {
  const SyntheticScene large = synthesize(Category::boxes, 1, 0, kinect_camera(1280, 960));
  const Segmenter whole, half(default_config(), {"signal.working_resolution=400000"});
  const SegmentedFrame found = half.segment(large.frame);
  EXPECT_EQ(found.segmentation.labels.size(), large.frame.depth.size());
  EXPECT_EQ(found.percept.frame().depth.size(), large.frame.depth.size());
  EXPECT_EQ(cv::countNonZero(found.segmentation.labels != 0), cv::countNonZero(large.frame.depth > 0));
  const auto score = score_image(large.ground_truth, found.segmentation.labels, RegionKind::objects);
  EXPECT_GT(summarise({score}, {""}).back().precision, 0.95);
  const Frame small = scene(Category::boxes).frame;
  expect_equal(run(half, small), run(whole, small));
}

TEST(DefaultSegmenter, HasAMinuteForAFrameWhereNoConfigSaysOtherwise) {
  EXPECT_EQ(Segmenter(default_config()).config().time_budget, 60'000);
  EXPECT_EQ(Segmenter(default_config(), {"time_budget=0"}).config().time_budget, 0);
}

TEST(DefaultSegmenter, RefusesAFrameOfTooManyPixels) {
  Frame frame;
  frame.name = "flat";
  frame.depth = cv::Mat_<float>::zeros(4097, 4096);
  try {
    Segmenter(default_config()).segment(frame);
    FAIL() << "a frame of 4096x4097 pixels";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("flat: has 4096x4097 pixels"), std::string::npos) << error.what();
  }
}

TEST(DefaultSegmenter, GivesTheSameWithTimeToSpare) {
  const Frame frame = scene(Category::mixed_objects).frame;
  expect_equal(run(Segmenter(default_config(), {"time_budget=" + std::to_string(hour)}), frame),
               run(Segmenter(), frame));
}

TEST(DefaultSegmenter, CountsTheTimeOfPerceptionToThatOfTheDecision) {
  const Segmenter gestalt(default_config(), {"time_budget=" + std::to_string(hour)});
  Percept percept = gestalt.pipeline().perceive(scene(Category::boxes).frame);
  EXPECT_NO_THROW(gestalt.pipeline().decide(percept, gestalt.models()));
  percept.times.signal = hour;
  EXPECT_THROW(gestalt.pipeline().decide(percept, gestalt.models()), TimeError);
}

TEST(DefaultSegmenter, FindsNoPairOnASinglePlane) {
  const Segmenter gestalt;
  const auto wall = test::render({{{0, 0, 640, 480}, {0, 0, 1}, {0, 0, -1}}});
  const auto [percept, segmentation, times] = gestalt.segment(wall.frame);
  EXPECT_EQ(percept.surfaces().surfaces.size(), 1u);
  EXPECT_TRUE(percept.structural.pairs.empty());
  EXPECT_EQ(segmentation.segments.size(), 1u);
  EXPECT_EQ(segmentation.segments[0].pixel_count, 640 * 480);
}

TEST(DefaultSegmenter, WorksOnAnyImageSize) {
  const Segmenter gestalt;
  for (const cv::Size size : {cv::Size(1, 1), cv::Size(1, 40), cv::Size(37, 3), cv::Size(1280, 960)}) {
    const auto frame =
        test::render({{{0, 0, size.width, size.height}, {0, 0, 1}, {0, 0, -1}}}, test::kinect(size.width, size.height))
            .frame;
    const Outcome outcome = run(gestalt, frame);
    EXPECT_EQ(outcome.labels.size(), size);
    EXPECT_EQ(cv::countNonZero(outcome.labels), size.area());
  }
}

TEST(DefaultSegmenter, RefusesAFrameWithoutColourWhenARelationNeedsIt) {
  const Segmenter gestalt;
  Frame frame = scene(Category::boxes).frame;
  frame.colour.release();
  try {
    gestalt.segment(frame);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("colour"), std::string::npos);
  }
  const LoadedConfig colourless(ConfigTree(
      default_config(), {"assembly.relations.colour_histogram=off", "structural.relations.colour_histogram=off",
                         "structural.relations.texture_quantity=off", "structural.relations.gabor=off",
                         "structural.relations.fourier=off", "structural.relations.border_colour=off"}));
  const Pipeline pipeline(colourless.config, colourless.registry);
  EXPECT_GT(pipeline.perceive(frame).structural.pairs.size(), 0u);
  EXPECT_THROW(pipeline.load_models(), ModelError);
}

// A loop that is cancelled ends early without a sign; what the pipeline gives must be complete all the same.
TEST(DefaultSegmenter, IsCompleteInAGroupThatIsCancelled) {
  const Segmenter gestalt;
  const Frame frame = scene(Category::mixed_objects).frame;
  const Outcome undisturbed = run(gestalt, frame);
  tbb::task_group_context group;
  tbb::parallel_for(
      0, 1,
      [&](int) {
        group.cancel_group_execution();
        expect_equal(run(gestalt, frame), undisturbed);
      },
      group);
}

TEST(DefaultModel, LearntFromRealAndSyntheticScenes) {
  EXPECT_EQ(Segmenter().models().structural.training.scenes.size(), 45u + 6 * 20 + 2 * 5 * 6 + 14);
}

TEST(DefaultModel, FindsTheObjectsOfTheLearnSet) {
  const std::filesystem::path folder = std::filesystem::path(GESTALT_SHARED_DATA) / "osd" / "learn";
  if (!std::filesystem::is_directory(folder)) GTEST_SKIP() << "the learn set is not at " << folder;
  const Segmenter gestalt;
  std::vector<ImageScore> scores;
  for (const auto& path : find_scenes({folder})) {
    const Input input = read_scene(path);
    const Segmentation segmentation = gestalt.segment(input.frame).segmentation;
    scores.push_back(score_image(input.ground_truth, segmentation.labels, RegionKind::objects));
  }
  const ScoreRow all = summarise(scores, std::vector<std::string>(scores.size())).back();
  EXPECT_GT(all.precision, 0.99);
  EXPECT_GT(all.recall, 0.98);
}

}  // namespace
}  // namespace gestalt
