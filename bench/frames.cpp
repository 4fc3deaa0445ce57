// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "frames.h"

#include <array>

#include "gestalt/io/scene/input.h"
#include "gestalt/synthesis/synthesis.h"

namespace gestalt::bench {

namespace {

/// A heap, blocks and stacks, rows, a box full of things, a shelf.
constexpr std::array crowded{Category::complex_scene, Category::packages, Category::groceries, Category::bin,
                             Category::shelf};

}  // namespace

Frames::Frames(const std::vector<std::filesystem::path>& paths, int synthetic_count)
    : count_(std::size_t(synthetic_count)) {
  if (paths.empty()) return;
  scenes_ = find_scenes(paths);
  count_ = scenes_.size();
}

LabelledFrame Frames::labelled(std::size_t i) const {
  if (scenes_.empty()) {
    SyntheticScene scene = synthesize(crowded[i % crowded.size()], 1, int(i / crowded.size()));
    return {std::move(scene.frame), scene.ground_truth};
  }
  Input input = read_scene(scenes_[i]);
  if (!input.ground_truth.empty()) input.ground_truth.setTo(0, input.frame.depth == 0);
  return {std::move(input.frame), input.ground_truth};
}

std::vector<Frame> Frames::all() const {
  std::vector<Frame> frames;
  for (std::size_t i = 0; i < size(); ++i) frames.push_back((*this)[i]);
  return frames;
}

}  // namespace gestalt::bench
