// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace gestalt::app {

/// While it lives, a frame is watched: after ten times its time budget, at least 5 s, the process ends with the exit
/// code run_failed and a message that names the running components, one of which does not return. Nothing else ends
/// those. A budget of 0 is watched by nobody.
class FrameWatch {
 public:
  FrameWatch(int budget_milliseconds, std::string frame);
  ~FrameWatch();
  FrameWatch(const FrameWatch&) = delete;
  FrameWatch& operator=(const FrameWatch&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  bool done_ = false;
  std::thread watcher_;
};

}  // namespace gestalt::app
