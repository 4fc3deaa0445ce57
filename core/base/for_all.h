// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/parallel_for.h>

#include <atomic>
#include <cstddef>
#include <exception>
#include <vector>

namespace gestalt {

/// work(0), ..., work(count - 1) in parallel. Throws the first error by index, so that it is the same in every run;
/// what comes after a failure may be left out, what comes before it is done. (tbb::parallel_for would cancel whatever
/// is running, and with it the loops within, which then end early without a sign.) Targets that include this link TBB.
template <class Work>
void for_all(std::size_t count, const Work& work) {
  std::vector<std::exception_ptr> failures(count);
  std::atomic<std::size_t> first_failed{count};
  tbb::parallel_for(std::size_t{0}, count, [&](std::size_t i) {
    if (i > first_failed) return;
    try {
      work(i);
    } catch (...) {
      failures[i] = std::current_exception();
      for (std::size_t known = first_failed; i < known && !first_failed.compare_exchange_weak(known, i);) {
      }
    }
  });
  if (first_failed < count) std::rethrow_exception(failures[first_failed]);
}

}  // namespace gestalt
