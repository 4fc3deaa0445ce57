// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <tbb/global_control.h>

#include <optional>

#include "gestalt/core/base/export.h"

namespace gestalt {

/// Bounds the threads of oneTBB, which everything of Gestalt uses, and of OpenCV while it lives. 0: no bound.
class GESTALT_EXPORT ThreadLimit {
 public:
  explicit ThreadLimit(int threads);
  ~ThreadLimit();
  ThreadLimit(const ThreadLimit&) = delete;
  ThreadLimit& operator=(const ThreadLimit&) = delete;

 private:
  std::optional<tbb::global_control> limit_;
  int opencv_threads_;  ///< before
};

}  // namespace gestalt
