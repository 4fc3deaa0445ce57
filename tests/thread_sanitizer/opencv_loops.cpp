// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

// OpenCV's loops by TBB as always, but compiled here, so that the thread sanitizer sees where they begin and end.

#include <opencv2/core/parallel/backend/parallel_for.tbb.hpp>

namespace {

[[maybe_unused]] const bool taken = [] {
  cv::parallel::setParallelForBackend(std::make_shared<cv::parallel::tbb::ParallelForBackend>());
  return true;
}();

}  // namespace
