// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/for_all.h"

#include <gtest/gtest.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <numeric>
#include <stdexcept>
#include <string>
#include <thread>

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

// The second item fails while the loop of the first is going on, which must not cut that short. (tbb::parallel_for
// would.)
TEST(ForAll, AnErrorDoesNotCutTheLoopsOfOthersShort) {
  std::atomic<bool> going_on = false, failed = false;
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(2);  // one thread would wait for itself
  const auto wait_for = [&](const std::atomic<bool>& event) {
    while (!event && std::chrono::steady_clock::now() < deadline) std::this_thread::yield();
  };
  std::atomic<int> done = 0;
  const auto work = [&](std::size_t i) {
    if (i == 1) {
      wait_for(going_on);
      failed = true;
      throw std::runtime_error("1");
    }
    tbb::parallel_for(0, 100, [&](int) {
      going_on = true;
      wait_for(failed);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
      ++done;
    });
  };
  EXPECT_THROW(for_all(2, work), std::runtime_error);
  EXPECT_EQ(done, 100);
}

}  // namespace
}  // namespace gestalt
