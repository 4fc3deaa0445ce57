// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_watch.h"

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "command.h"
#include "gestalt/running_component.h"

namespace gestalt::app {

namespace {

/// Destructors are not called: threads that do not return use what they would destroy.
[[noreturn]] void end(const std::string& frame, std::chrono::milliseconds patience) {
  std::string names;
  for (const char* name : running_components()) names += (names.empty() ? "" : ", ") + std::string(name);
  std::cerr << "gestalt: error: " << frame << ": not done after " << patience.count()
            << " ms, ten times its time_budget; at work: " << (names.empty() ? "no component" : names)
            << "; the process ends, as nothing else stops a component that does not return\n"
            << std::flush;
  std::_Exit(run_failed);
}

}  // namespace

FrameWatch::FrameWatch(int budget_milliseconds, std::string frame) {
  if (budget_milliseconds == 0) return;
  const std::chrono::milliseconds patience = std::chrono::milliseconds(budget_milliseconds) * 10;
  watcher_ = std::thread([this, patience, name = std::move(frame)] {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, patience, [&] { return done_; })) end(name, patience);
  });
}

FrameWatch::~FrameWatch() {
  if (!watcher_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    done_ = true;
  }
  changed_.notify_one();
  watcher_.join();
}

}  // namespace gestalt::app
