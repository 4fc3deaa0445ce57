// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/for_all.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <string>

namespace gestalt {
namespace {

TEST(ForAll, DoesEachOnce) {
  std::vector<int> done(1000, 0);
  for_all(done.size(), [&](std::size_t i) { ++done[i]; });
  EXPECT_EQ(done, std::vector<int>(1000, 1));
  for_all(0, [](std::size_t) { FAIL(); });
}

TEST(ForAll, ThrowsTheFirstErrorByIndex) {
  for (int run = 0; run < 200; ++run) {
    std::vector<int> done(100, 0);
    try {
      for_all(done.size(), [&](std::size_t i) {
        if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
        done[i] = 1;
      });
      FAIL();
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "7");
    }
    EXPECT_EQ(std::accumulate(done.begin(), done.begin() + 7, 0), 7) << "what comes before the error is done";
  }
}

// A loop within work that is going on when another item fails is not cut short.
TEST(ForAll, AnErrorDoesNotCutTheLoopsOfOthersShort) {
  for (int run = 0; run < 20; ++run)
    EXPECT_THROW(for_all(4,
                         [](std::size_t i) {
                           if (i == 3) throw std::runtime_error("3");
                           std::atomic<int> sum = 0;
                           tbb::parallel_for(0, 20000, [&](int) { ++sum; });
                           EXPECT_EQ(sum, 20000);
                         }),
                 std::runtime_error);
}

}  // namespace
}  // namespace gestalt
