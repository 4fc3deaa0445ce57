// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstddef>
#include <deque>
#include <filesystem>
#include <mutex>
#include <optional>
#include <vector>

namespace gestalt::app {

using Clock = std::chrono::steady_clock;

/// A frame that waits to be segmented.
struct WaitingFrame {
  std::filesystem::path scene;
  Clock::time_point arrived;
};

/// Frames on their way from the thread that sees them come to the one that segments them.
class FrameQueue {
 public:
  /// capacity: frames that may wait, at least 1. Nothing: only the newest waits, and those that it overtakes are
  /// dropped.
  explicit FrameQueue(std::optional<std::size_t> capacity) : capacity_(capacity) {}

  /// Where frames are dropped, a long list must not be in memory as a whole.
  static constexpr std::size_t most_at_once = 4096;

  /// Waits, for some time, until frames can be put in; gives how many. most_at_once where frames are dropped.
  std::size_t wait_for_room(Clock::duration patience);

  /// Frames that have come at once, oldest first, no more than there is room for. None is taken before all are in.
  void put(const std::vector<std::filesystem::path>& scenes);

  /// No more will come.
  void close();

  /// No more will be taken: what waits is left, and take() gives nothing from now on.
  void abandon();

  bool closed() const;

  /// Waits for the oldest frame. Nothing: there is none left and no more will come.
  std::optional<WaitingFrame> take();

  std::size_t dropped() const;

 private:
  const std::optional<std::size_t> capacity_;
  mutable std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<WaitingFrame> frames_;
  std::size_t dropped_ = 0;
  bool closed_ = false;
};

}  // namespace gestalt::app
