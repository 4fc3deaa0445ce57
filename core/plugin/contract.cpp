// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "contract.h"

#include <algorithm>
#include <cmath>

namespace gestalt {

namespace {

[[noreturn]] void broken(ComponentName component, const std::string& what) {
  throw PluginError(std::string(component) + " returned " + what + "; report this to its author");
}

}  // namespace

void require_patches(ComponentName clusterer, const PatchMap& patches, const Frame& frame) {
  if (patches.labels.size() != frame.depth.size() || patches.normals.size() != frame.depth.size())
    broken(clusterer, "labels or normals of another size than the frame's");
  if (!patches.cut_from.empty() && patches.cut_from.size() != std::size_t(std::max(0, patches.count)))
    broken(clusterer, "cut_from of " + std::to_string(patches.cut_from.size()) + " numbers for " +
                          std::to_string(patches.count) + " patches");
  if (!patches.labels.isContinuous() || !patches.normals.isContinuous())
    broken(clusterer, "labels or normals that are a part of a larger image; clone() them");
  if (patches.count < 0 || std::size_t(patches.count) > frame.depth.total())
    broken(clusterer,
           std::to_string(patches.count) + " patches for " + std::to_string(frame.depth.total()) + " pixels");
  std::vector<bool> used(std::size_t(patches.count) + 1, false);
  for (int v = 0; v < frame.height(); ++v) {
    const int* label = patches.labels[v];
    const cv::Vec3f* normal = patches.normals[v];
    const float* depth = frame.depth[v];
    for (int u = 0; u < frame.width(); ++u) {
      if (label[u] < 0 || label[u] > patches.count)
        broken(clusterer,
               "the label " + std::to_string(label[u]) + ", of " + std::to_string(patches.count) + " patches");
      used[std::size_t(label[u])] = true;
      if (label[u] > 0 && !(depth[u] > 0)) broken(clusterer, "a label for a pixel without depth");
      if (!std::isfinite(normal[u][0] + normal[u][1] + normal[u][2])) broken(clusterer, "a normal that is not finite");
    }
  }
  for (int label = 1; label <= patches.count; ++label)
    if (!used[std::size_t(label)])
      broken(clusterer,
             "no pixel of the label " + std::to_string(label) + ", of " + std::to_string(patches.count) + " patches");
}

void require_groups(ComponentName solver, const std::vector<int>& groups, std::size_t nodes) {
  if (groups.size() != nodes)
    broken(solver, std::to_string(groups.size()) + " groups for " + std::to_string(nodes) + " patches");
  for (const int group : groups)
    if (group < 0 || std::size_t(group) >= nodes)
      broken(solver, "the group " + std::to_string(group) + " for " + std::to_string(nodes) + " patches");
}

void require_probabilities(ComponentName classifier, std::span<const double> p) {
  for (const double one : p)
    if (!(one >= 0 && one <= 1)) broken(classifier, "the probability " + std::to_string(one));
}

}  // namespace gestalt
