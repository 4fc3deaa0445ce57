// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <atomic>

/// Two threads of a parallel loop write to a variable, and nothing that the sanitizer knows says which comes first. One
/// writes after the other, since it may miss two that write in the same moment; being relaxed, the counters order
/// nothing.
int main() {
  const tbb::global_control two(tbb::global_control::max_allowed_parallelism, 2);
  std::atomic<int> begun = 0, written = 0;
  int last = 0;
  tbb::task_arena(2).execute([&] {
    tbb::parallel_for(0, 2, [&](int i) {
      const int turn = begun.fetch_add(1, std::memory_order_relaxed);
      while (begun.load(std::memory_order_relaxed) < 2) {  // for the other thread
      }
      while (written.load(std::memory_order_relaxed) < turn) {
      }
      last = i;
      written.fetch_add(1, std::memory_order_relaxed);
    });
  });
  return last < 0;
}
