// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_refinement.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <tuple>
#include <vector>

#include "pixel_grid.h"
#include "running_plane.h"

namespace gestalt {

namespace {

class Refinement {
 public:
  Refinement(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances, LabelledPatches patches)
      : grid_(frame, normals), tolerances_(tolerances), patches_(std::move(patches)) {}

  /// Takes from every patch what a square of 2 * spur_radius + 1 pixels within it cannot reach: strips along creases
  /// and depth jumps, where a normal mixes two surfaces, and the thin ends of patches that crept along them.
  void cut_spurs() {
    const int radius = tolerances_.spur_radius();
    if (radius == 0) return;
    cv::Mat_<std::uint8_t> reached;
    cv::dilate(cores(radius), reached, cv::Mat_<std::uint8_t>::ones(2 * radius + 1, 2 * radius + 1));
    patches_.labels.setTo(0, reached == 0);
  }

  /// Gives pixels without a patch to a touching patch, the one whose plane is nearest first, when they lie within
  /// omega(z) of it and within spur_distance of the touching pixel.
  void reassign_leftovers() {
    struct Offer {
      float distance;
      int pixel, patch;
      bool operator<(const Offer& other) const {  // the queue's top is the smallest
        return std::tie(other.distance, other.pixel, other.patch) < std::tie(distance, pixel, patch);
      }
    };
    const std::vector<RunningPlane> planes = planes_of_patches();
    std::priority_queue<Offer> offers;
    const auto offer = [&](int from, int to) {
      if (label(to) != 0 || !grid_.valid(to)) return;
      const Eigen::Vector3f p = grid_.point(to);
      if ((p - grid_.point(from)).norm() > tolerances_.spur_distance(p.z())) return;
      const float distance = planes[std::size_t(label(from))].distance(p);
      if (distance <= tolerances_.distance(p.z())) offers.push({distance, to, label(from)});
    };
    for (int p = 0; p < grid_.size(); ++p)
      if (label(p) == 0 && grid_.valid(p))
        grid_.for_neighbours_4(p, [&](int q) {
          if (label(q) != 0) offer(q, p);
        });
    while (!offers.empty()) {
      const Offer best = offers.top();
      offers.pop();
      if (label(best.pixel) != 0) continue;
      label(best.pixel) = best.patch;
      grid_.for_neighbours_4(best.pixel, [&](int q) { offer(best.pixel, q); });
    }
  }

  /// Clusters what is still in no patch by connectivity; depth jumps separate.
  void gather_leftovers() {
    for (int seed = 0; seed < grid_.size(); ++seed) {
      if (label(seed) != 0 || !grid_.valid(seed)) continue;
      ++patches_.count;
      std::vector<int> component{seed};
      label(seed) = patches_.count;
      for (std::size_t i = 0; i < component.size(); ++i) {
        const float z = grid_.depth(component[i]);
        grid_.for_neighbours_4(component[i], [&](int q) {
          if (label(q) != 0 || !grid_.valid(q) || std::abs(z - grid_.depth(q)) > tolerances_.distance(z)) return;
          label(q) = patches_.count;
          component.push_back(q);
        });
      }
    }
  }

  /// Gives islands, left-over components of less than smallest_island pixels, to the patch of the touching pixel that
  /// is nearest in depth: too small to be related to anything, they are noise of the patch around them.
  void sink_islands(int first_island) {
    std::vector<std::vector<int>> islands(std::size_t(patches_.count - first_island + 1));
    for (int p = 0; p < grid_.size(); ++p)
      if (label(p) >= first_island) islands[std::size_t(label(p) - first_island)].push_back(p);
    const int smallest = tolerances_.smallest_island();
    const auto sinks = [&](int island_label) {
      return island_label >= first_island && int(islands[std::size_t(island_label - first_island)].size()) < smallest;
    };
    for (const std::vector<int>& island : islands) {
      if (int(island.size()) >= smallest) continue;
      int nearest = 0;
      float gap = std::numeric_limits<float>::infinity();
      for (const int p : island)
        grid_.for_neighbours_4(p, [&](int q) {
          const float d = std::abs(grid_.depth(p) - grid_.depth(q));
          if (label(q) == 0 || sinks(label(q)) || d > tolerances_.island_distance(grid_.depth(p)) || d >= gap) return;
          gap = d;
          nearest = label(q);
        });
      for (const int p : island) label(p) = nearest;
    }
  }

  /// Numbers the labels that are in use from 1 on, in their order.
  void close_gaps() {
    std::vector<int> number(std::size_t(patches_.count) + 1, 0);
    for (int p = 0; p < grid_.size(); ++p) number[std::size_t(label(p))] = 1;
    number[0] = 0;
    std::partial_sum(number.begin(), number.end(), number.begin());
    for (int p = 0; p < grid_.size(); ++p)
      if (label(p) != 0) label(p) = number[std::size_t(label(p))];
    patches_.count = number.back();
  }

  LabelledPatches result() { return std::move(patches_); }

 private:
  int& label(int pixel) { return patches_.labels.ptr<int>()[pixel]; }

  /// Marks the pixels around which the whole square is of one patch.
  cv::Mat_<std::uint8_t> cores(int radius) const {
    const int side = 2 * radius + 1;
    // run: how many pixels to the left, including this one, are of one patch; stack: how many rows above have full
    // runs.
    cv::Mat_<std::uint8_t> core(patches_.labels.size(), std::uint8_t{0});
    std::vector<int> stack(std::size_t(patches_.labels.cols), 0);
    for (int v = 0; v < patches_.labels.rows; ++v) {
      const int* row = patches_.labels[v];
      const int* above = v > 0 ? patches_.labels[v - 1] : nullptr;
      int run = 0;
      for (int u = 0; u < patches_.labels.cols; ++u) {
        run = row[u] == 0 ? 0 : u > 0 && row[u] == row[u - 1] ? run + 1 : 1;
        int& rows = stack[std::size_t(u)];
        rows = run < side ? 0 : above && above[u] == row[u] ? rows + 1 : 1;
        if (rows >= side) core(v - radius, u - radius) = 1;
      }
    }
    return core;
  }

  /// Mean planes by label.
  std::vector<RunningPlane> planes_of_patches() const {
    std::vector<RunningPlane> planes(std::size_t(patches_.count) + 1);
    for (int p = 0; p < grid_.size(); ++p)
      if (const int own = patches_.labels.ptr<int>()[p]; own != 0)
        planes[std::size_t(own)].sum(grid_.point(p), grid_.normal(p));
    for (RunningPlane& plane : planes)
      if (plane.count > 0) plane.update();
    return planes;
  }

  const PixelGrid grid_;
  const Tolerances& tolerances_;
  LabelledPatches patches_;
};

}  // namespace

LabelledPatches tidy_outlines(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances,
                              LabelledPatches patches) {
  Refinement refinement(frame, normals, tolerances, std::move(patches));
  refinement.cut_spurs();
  refinement.reassign_leftovers();
  return refinement.result();
}

LabelledPatches gather_leftovers(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances,
                                 LabelledPatches patches) {
  const int first_island = patches.count + 1;
  Refinement refinement(frame, normals, tolerances, std::move(patches));
  refinement.gather_leftovers();
  refinement.sink_islands(first_island);
  refinement.close_gaps();
  return refinement.result();
}

}  // namespace gestalt
