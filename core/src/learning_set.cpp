// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "gestalt/learning_set.h"

#include <algorithm>
#include <map>

#include "gestalt/error.h"

namespace gestalt {

std::vector<int> surface_objects(const SurfaceSet& surfaces, const cv::Mat_<std::uint16_t>& ground_truth) {
  if (ground_truth.size() != surfaces.labels.size())
    throw InputError("ground truth is " + std::to_string(ground_truth.cols) + "x" + std::to_string(ground_truth.rows) +
                     ", the frame " + std::to_string(surfaces.labels.cols) + "x" +
                     std::to_string(surfaces.labels.rows) + "; use the label image of this frame");
  std::vector<int> objects;
  for (const Surface& surface : surfaces.surfaces) {
    std::map<int, int> votes;
    for (const int pixel : surface.pixels)
      if (const int object = object_of_label(ground_truth.ptr<std::uint16_t>()[pixel]); object > 0) ++votes[object];
    const auto most =
        std::max_element(votes.begin(), votes.end(), [](const auto& x, const auto& y) { return x.second < y.second; });
    objects.push_back(most == votes.end() ? 0 : most->first);
  }
  return objects;
}

void append_pairs(const Percept& percept, const cv::Mat_<std::uint16_t>& ground_truth, Samples& samples) {
  const RelationTable& table = percept.relations;
  const std::vector<int> objects = surface_objects(percept.surfaces, ground_truth);
  samples.columns = table.names.size();
  for (std::size_t i = 0; i < table.pairs.size(); ++i) {
    const int a = objects[std::size_t(table.pairs[i].a)], b = objects[std::size_t(table.pairs[i].b)];
    if (a == 0 || b == 0 || (a == 1 && b == 1)) continue;
    samples.positive.push_back(a == b);
    const std::span<const double> row = table.row(i);
    samples.values.insert(samples.values.end(), row.begin(), row.end());
  }
}

}  // namespace gestalt
