// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/images.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <array>
#include <atomic>

#include "gestalt/core/base/error.h"
#include "gestalt/core/plugin/relation.h"
#include "gestalt/tests/scenes/test_scenes.h"

namespace gestalt {
namespace {

struct Noted final : Observation {
  int number = 0;
};

/// Notes how often it is asked to observe.
class Noting : public Relation {
 public:
  const std::vector<RelationValue>& values() const override {
    static const std::vector<RelationValue> values{{"r_number", 0, 1e9, "how many observations came before"}};
    return values;
  }
  std::unique_ptr<Observation> observe(const Images&) const override {
    auto noted = std::make_unique<Noted>();
    noted->number = count++;
    return noted;
  }
  std::unique_ptr<Measure> bind(const Scene&) const override { return nullptr; }

  mutable std::atomic<int> count = 0;
};

/// Observes nothing.
class Blind final : public Noting {
 public:
  std::unique_ptr<Observation> observe(const Images& images) const override { return Relation::observe(images); }
};

TEST(Images, GreyIsTheWeightedMeanOfTheColours) {
  auto scene = test::ridge(true);
  scene.frame.colour.setTo(cv::Scalar(200, 100, 50));
  const Images images(scene.frame);
  EXPECT_EQ(images.grey().type(), CV_8UC1);
  EXPECT_EQ(images.grey().at<uchar>(240, 320), 96);  // 0.114 * 200 + 0.587 * 100 + 0.299 * 50
  EXPECT_EQ(images.yuv().at<cv::Vec3b>(240, 320)[0], 96);
  scene.frame.colour.release();
  EXPECT_THROW(Images(scene.frame).grey(), InputError);
  EXPECT_THROW(Images(scene.frame).yuv(), InputError);
}

TEST(Images, KeepAnObservationForEachRelation) {
  const auto scene = test::ridge(true);
  const auto images = std::make_shared<Images>(scene.frame);
  const Noting one, other;
  const Blind blind;
  const Observation* first = images->observation(one);
  EXPECT_EQ(images->observation(one), first);
  EXPECT_EQ(one.count, 1);
  EXPECT_NE(images->observation(other), first);
  EXPECT_EQ(images->observation(blind), nullptr);
  const Scene seen(images, scene.patches, scene.surfaces);
  EXPECT_EQ(&seen.observed<Noted>(one), first);
  images->forget_observations();
  EXPECT_NE(images->observation(one), nullptr);
  EXPECT_EQ(one.count, 2);
}

TEST(Images, GiveAllThreadsTheSameObservation) {
  const auto scene = test::ridge(true);
  const Images images(scene.frame);
  const Noting relation;
  std::array<const Observation*, 64> given{};
  tbb::parallel_for(std::size_t{0}, given.size(), [&](std::size_t i) { given[i] = images.observation(relation); });
  for (const Observation* observation : given) EXPECT_EQ(observation, given[0]);
}

}  // namespace
}  // namespace gestalt
