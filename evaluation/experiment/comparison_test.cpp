// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "comparison.h"

#include <gtest/gtest.h>

namespace gestalt {
namespace {

const Comparison cells{{"boxes", "P", 99, 99.85},   {"boxes", "R", 95, 98.11},  {"stacked", "P", 96, 93.26},
                       {"stacked", "R", 96, 98.61}, {"all", "P", 93.75, 93.75}, {"all", "R", 91, 95.48}};

TEST(Comparison, CountsCellsWithinPoints) {
  EXPECT_EQ(count_within(cells, 1), 2);
  EXPECT_EQ(count_within(cells, 3), 4);
  EXPECT_EQ(count_within({{"all", "P", 93, 90}}, 3), 1);
  EXPECT_EQ(count_within({}, 3), 0);
}

TEST(Comparison, NamesTheCellsThatDifferByColumn) {
  EXPECT_EQ(differences_in_words(cells, 2), "P of stacked (+2.7); R of every row (-4.5 to -2.6)");
  EXPECT_EQ(differences_in_words(cells, 3), "R of boxes (-3.1), all (-4.5)");
  EXPECT_EQ(differences_in_words(cells, 5), "");
}

TEST(Comparison, DoesNotSpeakOfEveryRowOnBothSides) {
  EXPECT_EQ(differences_in_words({{"a", "P", 5, 0}, {"b", "P", 0, 5}, {"c", "P", 9, 0}}, 2),
            "P of a (+5.0), b (-5.0), c (+9.0)");
}

TEST(Comparison, KnowsOnWhichSideOfThePapersAColumnIs) {
  EXPECT_TRUE(exceeds(cells, "P", 2));
  EXPECT_FALSE(exceeds(cells, "P", 3));
  EXPECT_FALSE(exceeds(cells, "R", 0));
  EXPECT_TRUE(falls_short(cells, "R", 4));
  EXPECT_FALSE(falls_short(cells, "P", 2));
  EXPECT_FALSE(falls_short(cells, "BER", 0));
}

}  // namespace
}  // namespace gestalt
