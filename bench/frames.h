// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <vector>

#include "gestalt/core/scene/frame.h"

namespace gestalt::bench {

struct LabelledFrame {
  Frame frame;
  cv::Mat_<std::uint16_t> ground_truth;  ///< 0 also where there is no depth; empty when the scene has none
};

/// What is measured on: the scenes below some paths or, without paths, synthetic crowded scenes. Frames are made when
/// they are asked for, so that a program which holds one at a time has the peak memory of one.
class Frames {
 public:
  /// Throws InputError as find_scenes() does.
  Frames(const std::vector<std::filesystem::path>& paths, int synthetic_count);

  std::size_t size() const { return count_; }

  /// Throws InputError as read_scene() does.
  Frame operator[](std::size_t i) const { return labelled(i).frame; }

  /// The same with what the scene's labels say.
  LabelledFrame labelled(std::size_t i) const;

  std::vector<Frame> all() const;

 private:
  std::vector<std::filesystem::path> scenes_;
  std::size_t count_;
};

}  // namespace gestalt::bench
