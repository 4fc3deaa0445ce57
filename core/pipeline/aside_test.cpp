// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "aside.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>

#include <atomic>
#include <chrono>
#include <stdexcept>
#include <thread>

namespace gestalt {
namespace {

void add_up(std::atomic<int>& sum) {
  tbb::parallel_for(1, 101, [&](int i) { sum += i; });
}

TEST(Aside, IsDoneAfterTheWaitForAnyNumberOfThreads) {
  for (const std::size_t threads : {1, 2, 8}) {
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
    for (int run = 0; run < 20; ++run) {
      std::atomic<int> aside_sum = 0, own_sum = 0;
      Aside aside([&] { add_up(aside_sum); });
      add_up(own_sum);
      aside.wait();
      EXPECT_EQ(aside_sum, 5050);
      EXPECT_EQ(own_sum, 5050);
    }
  }
}

TEST(Aside, ThrowsWhatTheWorkHasThrown) {
  Aside aside([] { throw std::runtime_error("broken"); });
  EXPECT_THROW(aside.wait(), std::runtime_error);
}

TEST(Aside, DoesNotOutliveWhatItUses) {
  std::atomic<int> running = 0;
  try {
    std::atomic<int> sum = 0;
    const Aside aside([&] {
      ++running;
      add_up(sum);
      --running;
    });
    throw std::runtime_error("the caller fails");
  } catch (const std::runtime_error&) {
    EXPECT_EQ(running, 0);
  }
}

TEST(Aside, WhoFailsWithItsCallerLeavesTheCallersError) {
  std::atomic<bool> begun = false;
  try {
    const Aside aside([&] {
      begun = true;
      throw std::logic_error("that of the work");
    });
    // Where no thread is idle the work is not begun before it is cancelled.
    for (int i = 0; i < 1000 && !begun; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    throw std::runtime_error("that of the caller");
  } catch (const std::runtime_error& error) {
    EXPECT_STREQ(error.what(), "that of the caller");
  }
}

TEST(Aside, IsCompleteInAGroupThatIsCancelled) {
  std::atomic<int> sum = 0;
  tbb::task_group caller;
  caller.run_and_wait([&] {
    caller.cancel();
    Aside aside([&] { add_up(sum); });
    aside.wait();
  });
  EXPECT_EQ(sum, 5050);
}

}  // namespace
}  // namespace gestalt
