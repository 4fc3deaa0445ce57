// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_refinement.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <queue>
#include <tuple>
#include <vector>

#include "gestalt/core/base/wide.h"
#include "pixel_grid.h"
#include "running_plane.h"

namespace gestalt {

namespace {

/// Of a row of labels: whole is 1 where a pixel's patch goes on for side pixels to the right, same is 1 where it goes
/// on below; 0 elsewhere. alike: room for a row.
GESTALT_WIDE void compare(const int* row, const int* below, int width, int side, int* alike, std::uint8_t* whole,
                          std::uint8_t* same) {
  for (int u = 0; u < width; ++u) same[u] = row[u] == below[u];
  const int end = width - side;
  std::copy(row, row + end, alike);
  for (int d = 1; d <= side; ++d)
    for (int u = 0; u < end; ++u) alike[u] = row[u] == row[u + d] ? alike[u] : 0;
  for (int u = 0; u < end; ++u) whole[u] = alike[u] != 0;
}

class Refinement {
 public:
  Refinement(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances, LabelledPatches patches)
      : grid_(frame, normals),
        tolerances_(tolerances),
        patches_(std::move(patches)),
        labels_(patches_.labels.ptr<int>()) {}

  /// Takes from every patch what a square of 2 * spur_radius + 1 pixels within it cannot reach: strips along creases
  /// and depth jumps, where a normal mixes two surfaces, and the thin ends of patches that crept along them.
  void cut_spurs() {
    const int radius = tolerances_.spur_radius();
    if (radius == 0) return;
    if (2 * radius >= std::min(patches_.labels.cols, patches_.labels.rows)) {  // no such square is in the image
      patches_.labels.setTo(0);
      return;
    }
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
  int& label(int pixel) const { return labels_[pixel]; }

  /// Marks the pixels around which the whole square is of one patch. It must fit in the image.
  cv::Mat_<std::uint8_t> cores(int radius) const {
    const cv::Mat_<int>& labels = patches_.labels;
    const int width = labels.cols, height = labels.rows, side = 2 * radius;
    cv::Mat_<std::uint8_t> core(labels.size(), std::uint8_t{0});
    // A square is of one patch when its rows are and its middle column is.
    cv::Mat_<std::uint8_t> in_row(labels.size(), std::uint8_t{0}), as_below(labels.size());
    tbb::parallel_for(0, height, [&](int v) {
      std::vector<int> alike(static_cast<std::size_t>(width));
      compare(labels[v], labels[std::min(v + 1, height - 1)], width, side, alike.data(), in_row[v] + radius,
              as_below[v]);
    });
    tbb::parallel_for(radius, height - radius, [&](int v) {
      cv::Mat_<std::uint8_t> whole = core.row(v);
      in_row.row(v).copyTo(whole);
      for (int d = -radius; d <= radius; ++d) {
        cv::bitwise_and(whole, in_row.row(v + d), whole);
        if (d < radius) cv::bitwise_and(whole, as_below.row(v + d), whole);
      }
    });
    return core;
  }

  /// Mean planes by label.
  std::vector<RunningPlane> planes_of_patches() const {
    std::vector<RunningPlane> planes(std::size_t(patches_.count) + 1);
    for (int p = 0; p < grid_.size();) {
      const int own = label(p);
      RunningPlane run;  // of neighbouring pixels, in registers
      for (; p < grid_.size() && label(p) == own; ++p)
        if (own != 0) run.sum(grid_.point(p), grid_.normal(p));
      planes[std::size_t(own)].add(run);
    }
    for (RunningPlane& plane : planes)
      if (plane.count > 0) plane.update();
    return planes;
  }

  const PixelGrid grid_;
  const Tolerances& tolerances_;
  LabelledPatches patches_;
  int* const labels_;
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
