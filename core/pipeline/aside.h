// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/task_arena.h>
#include <tbb/task_group.h>

namespace gestalt {

/// Work that is done by threads that the caller's own parallel loops leave idle, no more of them than the caller may
/// use; the rest of it by the thread that waits.
class Aside {
 public:
  template <class Work>
  explicit Aside(const Work& work) {
    arena_.execute([&] { group_.run(work); });
  }
  ~Aside() {
    if (waited_) return;
    group_.cancel();
    try {
      arena_.execute([&] { group_.wait(); });
    } catch (...) {  // a caller that does not wait is leaving with another exception
    }
  }
  Aside(const Aside&) = delete;
  Aside& operator=(const Aside&) = delete;

  /// Returns when all is done; throws what the work has thrown.
  void wait() {
    waited_ = true;
    arena_.execute([&] { group_.wait(); });
  }

 private:
  tbb::task_arena arena_{tbb::this_task_arena::max_concurrency(), 1, tbb::task_arena::priority::low};
  tbb::task_group_context context_{tbb::task_group_context::isolated};
  tbb::task_group group_{context_};
  bool waited_ = false;
};

}  // namespace gestalt
