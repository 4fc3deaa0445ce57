// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/tracking/tracker.h"

#include <gtest/gtest.h>

#include "gestalt/core/base/error.h"

namespace gestalt {
namespace {

/// A rectangle that faces the camera, in one colour.
struct Card {
  cv::Rect pixels;
  double grey = 100;
  float depth = 1;
};

/// Cards before a wall 2 m away, later ones before earlier ones, at 320x240 pixels with f = 250 px: a pixel at 1 m is 4
/// mm wide.
struct View {
  explicit View(const std::vector<Card>& cards) {
    cv::Mat_<float> depth(240, 320, 2.f);
    labels = cv::Mat_<std::uint16_t>::zeros(240, 320);
    for (std::size_t i = 0; i < cards.size(); ++i) {
      labels(cards[i].pixels) = std::uint16_t(i + 1);
      depth(cards[i].pixels) = cards[i].depth;
    }
    frame = make_frame("view", {}, depth, {320, 240, 250, 250, 159.5, 119.5});
    for (std::size_t i = 0; i < cards.size(); ++i) {
      ObjectDescription object;
      object.label = int(i) + 1;
      const cv::Mat mask = labels == object.label;
      object.pixels = cv::countNonZero(mask);
      if (object.pixels == 0) continue;
      object.box = cards[i].pixels;
      for (int v = 0; v < 240; ++v)
        for (int u = 0; u < 320; ++u)
          if (labels(v, u) == object.label) object.centroid += frame.point(v * 320 + u).cast<double>() / object.pixels;
      object.colour = Colour{Eigen::Vector3d::Constant(cards[i].grey), Eigen::Vector3d::Zero()};
      objects.push_back(object);
    }
  }

  Frame frame;
  cv::Mat_<std::uint16_t> labels;
  std::vector<ObjectDescription> objects;
};

FrameTracks follow(Tracker& tracker, const std::vector<Card>& cards,
                   const std::optional<Eigen::Isometry3d>& pose = std::nullopt) {
  const View view(cards);
  return tracker.update(view.frame, view.labels, view.objects, pose);
}

using Numbers = std::vector<int>;

TEST(Tracker, NumbersNewObjectsFromOne) {
  Tracker tracker;
  const FrameTracks tracks = follow(tracker, {{{20, 20, 40, 40}}, {{200, 100, 40, 40}}});
  EXPECT_EQ(tracks.numbers, (Numbers{1, 2}));
  EXPECT_EQ(tracks.appeared, (Numbers{1, 2}));
  EXPECT_TRUE(tracks.hidden.empty() && tracks.lost.empty() && tracks.split.empty() && tracks.merged.empty());
}

TEST(Tracker, FollowsOverlapWhateverTheLabels) {
  Tracker tracker;
  follow(tracker, {{{20, 20, 40, 40}}, {{200, 100, 40, 40}}});
  const FrameTracks tracks = follow(tracker, {{{204, 102, 40, 40}}, {{24, 22, 40, 40}}});
  EXPECT_EQ(tracks.numbers, (Numbers{2, 1}));
  EXPECT_TRUE(tracks.appeared.empty());
}

TEST(Tracker, FollowsAFastObjectByColourAndSizeAndNotToAnother) {
  Tracker tracker;
  follow(tracker, {{{100, 100, 20, 20}, 200}});
  EXPECT_EQ(follow(tracker, {{{125, 100, 20, 20}, 200}}).numbers, Numbers{1});  // 10 cm
  EXPECT_EQ(follow(tracker, {{{100, 100, 20, 20}, 80}}).numbers, Numbers{2});   // of another colour
  EXPECT_EQ(follow(tracker, {{{70, 100, 20, 60}, 80}}).numbers, Numbers{3});    // three times as large
  EXPECT_EQ(follow(tracker, {{{200, 100, 20, 60}, 80}}).numbers, Numbers{4});   // 52 cm
}

TEST(Tracker, KeepsTheNumberOfAHiddenObjectForSomeFrames) {
  TrackerParams params;
  params.keep = 2;
  Tracker tracker(params);
  const Card card{{100, 100, 20, 20}};
  follow(tracker, {card});
  EXPECT_EQ(follow(tracker, {}).hidden, Numbers{1});
  EXPECT_EQ(follow(tracker, {}).hidden, Numbers{1});
  EXPECT_EQ(follow(tracker, {card}).numbers, Numbers{1});
  follow(tracker, {});
  follow(tracker, {});
  const FrameTracks third = follow(tracker, {});
  EXPECT_EQ(third.lost, Numbers{1});
  EXPECT_TRUE(third.hidden.empty());
  const FrameTracks again = follow(tracker, {card});
  EXPECT_EQ(again.numbers, Numbers{2});
  EXPECT_EQ(again.appeared, Numbers{2});
}

TEST(Tracker, WhatHidesAnObjectDoesNotTakeItsNumber) {
  Tracker tracker;
  const Card back{{100, 100, 30, 30}, 100, 1.5f};
  follow(tracker, {back});
  const FrameTracks covered = follow(tracker, {{{95, 95, 45, 45}, 100, 0.8f}});
  EXPECT_EQ(covered.numbers, Numbers{2});
  EXPECT_EQ(covered.hidden, Numbers{1});
  EXPECT_TRUE(covered.merged.empty());
  EXPECT_EQ(follow(tracker, {back}).numbers, Numbers{1});
}

TEST(Tracker, ReportsWhatSplitsAndMerges) {
  Tracker tracker;
  follow(tracker, {{{100, 100, 60, 30}}});
  const FrameTracks split = follow(tracker, {{{100, 100, 40, 30}}, {{140, 100, 20, 30}}});
  EXPECT_EQ(split.numbers, (Numbers{1, 2}));
  ASSERT_EQ(split.split.size(), 1u);
  EXPECT_EQ(split.split[0].from, 1);
  EXPECT_EQ(split.split[0].into, 2);
  const FrameTracks merged = follow(tracker, {{{100, 100, 60, 30}}});
  EXPECT_EQ(merged.numbers, Numbers{1});
  ASSERT_EQ(merged.merged.size(), 1u);
  EXPECT_EQ(merged.merged[0].from, 2);
  EXPECT_EQ(merged.merged[0].into, 1);
  EXPECT_EQ(follow(tracker, {{{100, 100, 40, 30}}, {{140, 100, 20, 30}}}).numbers, (Numbers{1, 2}));
}

TEST(Tracker, AccountsForTheMotionOfTheCamera) {
  // The camera moves 16 cm to the right: cards at 1 m move by 40 pixels, so that each lies where the other one was.
  const std::vector<Card> before{{{140, 100, 20, 20}}, {{180, 100, 20, 20}}},
      after{{{100, 100, 20, 20}}, {{140, 100, 20, 20}}};
  const Eigen::Isometry3d moved(Eigen::Translation3d(0.16, 0, 0));
  Tracker with, without;
  follow(with, before, Eigen::Isometry3d::Identity());
  EXPECT_EQ(follow(with, after, moved).numbers, (Numbers{1, 2}));
  follow(without, before);
  EXPECT_EQ(follow(without, after).numbers[1], 1);
}

TEST(Tracker, RefusesLabelsOfAnotherSize) {
  const View view({{{100, 100, 20, 20}}});
  Tracker tracker;
  EXPECT_THROW(tracker.update(view.frame, cv::Mat_<std::uint16_t>::zeros(10, 10), view.objects), InputError);
}

}  // namespace
}  // namespace gestalt
