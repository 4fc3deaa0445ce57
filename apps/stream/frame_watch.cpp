// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_watch.h"

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <iostream>

#include "gestalt/apps/commands/command.h"
#include "gestalt/core/plugin/running_component.h"

namespace gestalt::app {

namespace {

using namespace std::chrono_literals;

/// A component that does return, if late, fails its frame alone.
constexpr std::chrono::milliseconds least_patience = 5s;

/// Destructors are not called: threads that do not return use what they would destroy.
[[noreturn]] void end(const std::string& frame, int budget, std::chrono::milliseconds patience) {
  std::string names;
  for (const char* name : running_components()) names += (names.empty() ? "" : ", ") + std::string(name);
  std::cerr << "gestalt: error: " << frame << ": still running after " << patience.count()
            << " ms, with a time_budget of " << budget << " ms; running: " << (names.empty() ? "no component" : names)
            << "; ending the process, because a component that does not return cannot be stopped\n"
            << std::flush;
  std::_Exit(run_failed);
}

}  // namespace

FrameWatch::FrameWatch(int budget_milliseconds, std::string frame) {
  if (budget_milliseconds == 0) return;
  const std::chrono::milliseconds patience = std::max(least_patience, budget_milliseconds * 10ms);
  watcher_ = std::thread([this, budget_milliseconds, patience, name = std::move(frame)] {
    std::unique_lock lock(mutex_);
    if (!changed_.wait_for(lock, patience, [&] { return done_; })) end(name, budget_milliseconds, patience);
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
