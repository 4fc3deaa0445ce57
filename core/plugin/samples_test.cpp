// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <gtest/gtest.h>

#include "gestalt/core/plugin/classifier.h"

namespace gestalt {
namespace {

const Samples first{2, {1, 2, 3, 4}, {1, 0}};
const Samples second{2, {5, 6}, {1}};

TEST(Samples, AreAppendedRowByRow) {
  Samples all = first;
  all.append(second);
  EXPECT_EQ(all.columns, 2u);
  EXPECT_EQ(all.values, (std::vector<double>{1, 2, 3, 4, 5, 6}));
  EXPECT_EQ(all.positive, (std::vector<std::uint8_t>{1, 0, 1}));
  EXPECT_EQ(all.rows(), 3u);
  EXPECT_EQ(all.row(2)[1], 6);
}

TEST(Samples, GetTheirColumnsFromTheFirstThatAreAppended) {
  Samples all;
  all.append(second);
  EXPECT_EQ(all.columns, 2u);
  EXPECT_EQ(all.rows(), 1u);
}

}  // namespace
}  // namespace gestalt
