// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

/// Two threads of a parallel loop write to a variable, and nothing says which comes first.
int main() {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  std::atomic<int> begun = 0;
  int last = 0;
  tbb::task_arena(2).execute([&] {
    tbb::parallel_for(0, 2, [&](int i) {
      begun.fetch_add(1, std::memory_order_relaxed);
      while (begun.load(std::memory_order_relaxed) < 2) {  // for the other thread; being relaxed, it orders nothing
      }
      last = i;
    });
  });
  return last < 0;
}
