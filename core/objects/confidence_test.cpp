// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "confidence.h"

#include <gtest/gtest.h>

#include <cmath>

namespace gestalt {
namespace {

/// Object 1 of surfaces 0 and 1 (1000 and 500 pixels), object 2 of surface 2, background of surface 3.
Segmentation segmentation(double join, double cut) {
  Segmentation made;
  made.segments = {{{0, 1}, 1500, Role::object}, {{2}, 800, Role::object}, {{3}, 700, Role::background}};
  made.graph.sizes = {1000, 500, 800, 700};
  made.graph.edges = {{0, 1, join, Level::structural}, {0, 3, 0.9, Level::structural}, {1, 2, cut, Level::assembly}};
  return made;
}

double confidence(double join, double cut, double density = 1) {
  return find_certainties(segmentation(join, cut), density)[0].confidence;
}

TEST(Confidence, IsTheLogisticFunctionOfItsFourNumbers) {
  const double score =
      -6.824 + 0.139 * std::log(9.0) - 0.452 * std::log(0.25) + 0.658 * std::log(2.0) + 0.844 * std::log(1500.0);
  EXPECT_NEAR(confidence(0.9, 0.2), 1 / (1 + std::exp(-score)), 1e-12);
}

TEST(Confidence, FallsWithAWeakJoinALikelyCutAndFewPixels) {
  EXPECT_GT(confidence(0.9, 0.1), confidence(0.5, 0.1));
  EXPECT_GT(confidence(0.9, 0.1), confidence(0.9, 0.6));
  EXPECT_GT(confidence(0.9, 0.1, 1), confidence(0.9, 0.1, 4));
  EXPECT_EQ(confidence(1, 0.1), confidence(0.9999, 0.1));  // p is not certain
}

TEST(Confidence, NamesCloseDecisions) {
  const std::vector<Certainty> certainties = find_certainties(segmentation(0.55, 0.45), 1);
  ASSERT_EQ(certainties.size(), 3u);
  ASSERT_EQ(certainties[0].joins.size(), 1u);
  EXPECT_EQ(certainties[0].joins[0].a, 0);
  EXPECT_EQ(certainties[0].joins[0].b, 1);
  EXPECT_EQ(certainties[0].joins[0].probability, 0.55);
  for (const int object : {0, 1}) {
    ASSERT_EQ(certainties[std::size_t(object)].cuts.size(), 1u);
    EXPECT_EQ(certainties[std::size_t(object)].cuts[0].probability, 0.45);
  }
  EXPECT_TRUE(certainties[1].joins.empty());
  EXPECT_EQ(certainties[2].confidence, 0);  // background
  EXPECT_TRUE(find_certainties(segmentation(0.9, 0.1), 1)[0].joins.empty());
}

TEST(Confidence, ASpeckThatHangsOnByLittleDoesNotCount) {
  Segmentation with_speck = segmentation(0.9, 0.1);
  with_speck.segments[0].surfaces.push_back(4);
  with_speck.graph.sizes.push_back(10);
  with_speck.graph.edges.push_back({1, 4, 0.3, Level::structural});
  EXPECT_TRUE(find_certainties(with_speck, 1)[0].joins.empty());
}

TEST(Confidence, OfNothingIsNothing) { EXPECT_TRUE(find_certainties({}, 1).empty()); }

}  // namespace
}  // namespace gestalt
