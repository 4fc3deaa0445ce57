// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_growing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

#include "pixel_grid.h"
#include "running_plane.h"
#include "tolerance_memory.h"

namespace gestalt {

namespace {

class Growing {
 public:
  Growing(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances)
      : grid_(frame, normals),
        smallest_(tolerances.min_patch_size()),
        tolerances_(tolerances),
        patches_{cv::Mat_<int>(frame.depth.size(), 0), 0},
        labels_(patches_.labels.ptr<int>()) {
    for (int pixel = 0; pixel < grid_.size(); ++pixel)
      if (!grid_.has_normal(pixel)) label(pixel) = no_normal;
  }

  /// From all pixels with a normal, flattest first; ties in row-major order.
  LabelledPatches grow_all() {
    // Most of a frame is taken by patches that grow from the flattest pixels; only what they leave need be sorted.
    const int flat = flat_bins();
    grow_from_seeds(0, flat);
    grow_from_seeds(flat, bins);
    patches_.labels.setTo(0, patches_.labels == no_normal);
    return std::move(patches_);
  }

 private:
  static constexpr int no_normal = -1;
  static constexpr int bins = 4096;

  int& label(int pixel) { return labels_[pixel]; }

  /// Of the curvature. Flat surfaces differ by far less than 1/3 over bins: the square root spreads them.
  int bin(int pixel) const { return std::min(bins - 1, int(std::sqrt(grid_.curvature(pixel) * 3) * bins)); }

  /// The bins of about the flattest eighth of the pixels, by a sample of them.
  int flat_bins() {
    std::vector<int> sample;
    for (int pixel = 0; pixel < grid_.size(); pixel += 61)
      if (label(pixel) != no_normal) sample.push_back(bin(pixel));
    if (sample.empty()) return 0;
    const auto eighth = sample.begin() + std::ptrdiff_t(sample.size() / 8);
    std::nth_element(sample.begin(), eighth, sample.end());
    return *eighth + 1;
  }

  /// From the pixels of these bins that are in no patch yet.
  void grow_from_seeds(int first_bin, int end_bin) {
    const float above = float(end_bin + 1) / bins, limit = end_bin < bins ? above * above / 3 : 1;  // saves roots
    std::array<int, bins + 1> start{};
    std::vector<std::pair<int, int>> found;  // bin, pixel
    for (int pixel = 0; pixel < grid_.size(); ++pixel) {
      if (label(pixel) != 0 || grid_.curvature(pixel) > limit) continue;
      const int own = bin(pixel);
      if (own < first_bin || own >= end_bin) continue;
      found.emplace_back(own, pixel);
      ++start[std::size_t(own) + 1];
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> seeds(found.size());
    for (const auto& [own, pixel] : found) seeds[std::size_t(start[std::size_t(own)]++)] = pixel;
    for (const int seed : seeds)
      if (label(seed) == 0) grow(seed);
  }

  void grow(int seed) {
    RunningPlane plane;
    const int own = ++patches_.count;
    front_.assign(1, seed);
    label(seed) = own;
    plane.sum(grid_.point(seed), grid_.normal(seed));
    plane.update();
    double next_update = 0;
    refused_.clear();
    const auto ask_neighbours = [&](int pixel) {
      bool refused = false;
      grid_.for_neighbours_4(pixel, [&](int q) {
        if (label(q) != 0) return;
        const Eigen::Vector3f p = grid_.point(q), n = grid_.normal(q);
        if (plane.distance(p) > tolerances_.distance(p.z()) || n.dot(plane.normal) < tolerances_.cosine(p.z())) {
          refused = true;
          return;
        }
        label(q) = own;
        front_.push_back(q);
        plane.sum(p, n);
        // The mean of many hardly moves: it is taken anew when a 1024th is added.
        if (plane.count < next_update) return;
        plane.update();
        next_update = plane.count * (1 + 1. / 1024);
      });
      return refused;
    };
    std::size_t asked = 0;
    for (; asked < front_.size(); ++asked)
      if (ask_neighbours(front_[asked])) refused_.push_back(front_[asked]);
    // The plane of a young patch wobbles and turns pixels away that belong to it: once it has settled, all are asked
    // again.
    for (const int pixel : refused_) ask_neighbours(pixel);
    for (; asked < front_.size(); ++asked) ask_neighbours(front_[asked]);
    if (int(front_.size()) >= smallest_) return;
    for (const int pixel : front_) label(pixel) = 0;
    --patches_.count;
  }

  const PixelGrid grid_;
  const int smallest_;
  ToleranceMemory tolerances_;
  LabelledPatches patches_;
  int* const labels_;
  std::vector<int> front_;
  std::vector<int> refused_;  // of the front, those beside a pixel that was turned away
};

}  // namespace

LabelledPatches grow_patches(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances) {
  return Growing(frame, normals, tolerances).grow_all();
}

}  // namespace gestalt
