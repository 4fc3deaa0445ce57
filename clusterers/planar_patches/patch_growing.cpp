// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_growing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <vector>

#include "pixel_grid.h"
#include "running_plane.h"
#include "tolerance_memory.h"

namespace gestalt {

namespace {

/// Pixels with a normal, flattest first; ties in row-major order.
std::vector<int> seeds_by_curvature(const NormalMap& normals) {
  constexpr int bins = 4096;
  const float* curvature = normals.curvature.ptr<float>();
  const int pixels = int(normals.curvature.total());
  // Flat surfaces differ by far less than 1/3 over bins: the square root spreads them.
  const auto bin = [&](int i) { return std::min(bins - 1, int(std::sqrt(curvature[i] * 3) * bins)); };
  std::array<int, bins + 1> start{};
  for (int i = 0; i < pixels; ++i)
    if (curvature[i] < 1) ++start[std::size_t(bin(i)) + 1];
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> seeds(std::size_t(start.back()));
  for (int i = 0; i < pixels; ++i)
    if (curvature[i] < 1) seeds[std::size_t(start[std::size_t(bin(i))]++)] = i;
  return seeds;
}

class Growing {
 public:
  Growing(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances)
      : grid_(frame, normals),
        smallest_(tolerances.min_patch_size()),
        tolerances_(tolerances),
        patches_{cv::Mat_<int>(frame.depth.size(), 0), 0} {}

  LabelledPatches grow_from_seeds(const std::vector<int>& seeds) {
    for (const int seed : seeds)
      if (label(seed) == 0) grow(seed);
    return std::move(patches_);
  }

 private:
  int& label(int pixel) { return patches_.labels.ptr<int>()[pixel]; }

  void grow(int seed) {
    RunningPlane plane;
    const int own = ++patches_.count;
    front_.assign(1, seed);
    label(seed) = own;
    plane.sum(grid_.point(seed), grid_.normal(seed));
    plane.update();
    double next_update = 0;
    // The plane of a young patch wobbles and turns pixels away that belong to it: once it has settled, all are asked
    // again.
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0; i < front_.size(); ++i)
        grid_.for_neighbours_4(front_[i], [&](int q) {
          if (label(q) != 0 || !grid_.has_normal(q)) return;
          const Eigen::Vector3f p = grid_.point(q), n = grid_.normal(q);
          if (plane.distance(p) > tolerances_.distance(p.z()) || n.dot(plane.normal) < tolerances_.cosine(p.z()))
            return;
          label(q) = own;
          front_.push_back(q);
          plane.sum(p, n);
          // The mean of many hardly moves: it is taken anew when a 1024th is added.
          if (plane.count < next_update) return;
          plane.update();
          next_update = plane.count * (1 + 1. / 1024);
        });
    if (int(front_.size()) >= smallest_) return;
    for (const int pixel : front_) label(pixel) = 0;
    --patches_.count;
  }

  const PixelGrid grid_;
  const int smallest_;
  ToleranceMemory tolerances_;
  LabelledPatches patches_;
  std::vector<int> front_;
};

}  // namespace

LabelledPatches grow_patches(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances) {
  return Growing(frame, normals, tolerances).grow_from_seeds(seeds_by_curvature(normals));
}

}  // namespace gestalt
