// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/scene/histogram.h"

#include <gtest/gtest.h>

#include <array>

namespace gestalt {
namespace {

TEST(Histogram, RootSharesSquareToShares) {
  std::array<float, 3> counts{1, 0, 3};
  take_root_shares(counts);
  EXPECT_FLOAT_EQ(counts[0], 0.5f);
  EXPECT_FLOAT_EQ(counts[1], 0.f);
  EXPECT_FLOAT_EQ(counts[2], std::sqrt(0.75f));
}

TEST(Histogram, EmptyOneStaysZero) {
  std::array<float, 2> counts{0, 0};
  take_root_shares(counts);
  EXPECT_EQ(counts, (std::array<float, 2>{0, 0}));
}

TEST(Histogram, BhattacharyyaIsOneForEqualSharesWhateverTheCounts) {
  std::array<float, 3> p{1, 2, 5}, q{10, 20, 50};
  take_root_shares(p);
  take_root_shares(q);
  EXPECT_NEAR(bhattacharyya(p, q), 1, 1e-6);
  EXPECT_LE(bhattacharyya(p, q), 1);
}

TEST(Histogram, BhattacharyyaIsTheSumOfRootProducts) {
  std::array<float, 2> p{1, 3}, q{1, 1};
  take_root_shares(p);
  take_root_shares(q);
  EXPECT_NEAR(bhattacharyya(p, q), std::sqrt(0.25 * 0.5) + std::sqrt(0.75 * 0.5), 1e-6);
}

TEST(Histogram, BhattacharyyaIsZeroWithoutACommonBin) {
  std::array<float, 2> p{4, 0}, q{0, 9};
  take_root_shares(p);
  take_root_shares(q);
  EXPECT_EQ(bhattacharyya(p, q), 0);
}

}  // namespace
}  // namespace gestalt
