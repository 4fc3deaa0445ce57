// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frames.h"

#include "gestalt/io/scene/input.h"
#include "gestalt/synthesis/synthesis.h"

namespace gestalt::bench {

Frames::Frames(const std::vector<std::filesystem::path>& paths, int synthetic_count)
    : count_(std::size_t(synthetic_count)) {
  if (paths.empty()) return;
  scenes_ = find_scenes(paths);
  count_ = scenes_.size();
}

Frame Frames::operator[](std::size_t i) const {
  return scenes_.empty() ? synthesize(Category::complex_scene, 1, int(i)).frame : read_scene(scenes_[i]).frame;
}

std::vector<Frame> Frames::all() const {
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < size(); ++i) frames.push_back((*this)[i]);
  return frames;
}

}  // namespace gestalt::bench
