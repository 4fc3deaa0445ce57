// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/core/base/thread_limit.h"

#include <opencv2/core/utility.hpp>

namespace gestalt {

ThreadLimit::ThreadLimit(int threads) : opencv_threads_(cv::getNumThreads()) {
  if (threads == 0) return;
  limit_.emplace(tbb::global_control::max_allowed_parallelism, std::size_t(threads));
  cv::setNumThreads(threads);
}

ThreadLimit::~ThreadLimit() { cv::setNumThreads(opencv_threads_); }

}  // namespace gestalt
