// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frame_queue.h"

namespace gestalt::app {

std::size_t FrameQueue::wait_for_room(Clock::duration patience) {
  if (!capacity_) return most_at_once;
  std::unique_lock lock(mutex_);
  changed_.wait_for(lock, patience, [&] { return frames_.size() < *capacity_; });
  return *capacity_ - frames_.size();
}

void FrameQueue::put(const std::vector<std::filesystem::path>& scenes) {
  const std::lock_guard lock(mutex_);
  for (const std::filesystem::path& scene : scenes) frames_.push_back({scene, Clock::now()});
  if (!capacity_ && frames_.size() > 1) {
    dropped_ += frames_.size() - 1;
    frames_.erase(frames_.begin(), frames_.end() - 1);
  }
  changed_.notify_all();
}

void FrameQueue::close() {
  const std::lock_guard lock(mutex_);
  closed_ = true;
  changed_.notify_all();
}

void FrameQueue::abandon() {
  const std::lock_guard lock(mutex_);
  frames_.clear();
  closed_ = true;
  changed_.notify_all();
}

bool FrameQueue::closed() const {
  const std::lock_guard lock(mutex_);
  return closed_;
}

std::optional<WaitingFrame> FrameQueue::take() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [&] { return closed_ || !frames_.empty(); });
  if (frames_.empty()) return std::nullopt;
  WaitingFrame frame = std::move(frames_.front());
  frames_.pop_front();
  changed_.notify_all();
  return frame;
}

std::size_t FrameQueue::dropped() const {
  const std::lock_guard lock(mutex_);
  return dropped_;
}

}  // namespace gestalt::app
