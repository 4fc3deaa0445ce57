// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_growing.h"

#include <tbb/parallel_for.h>

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

#include "running_plane.h"
#include "tolerance_memory.h"

namespace gestalt {

namespace {

/// Grows patches over an image with a margin of one pixel around it, which is never taken: every pixel then has its
/// four neighbours, at the same steps. What is asked of a pixel lies together: growth jumps from row to row.
class Growing {
 public:
  Growing(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances)
      : size_(frame.depth.size()),
        stride_(size_.width + 2),
        curvature_(normals.curvature),
        smallest_(tolerances.min_patch_size()),
        tolerances_(tolerances),
        cells_(std::make_unique_for_overwrite<Cell[]>(std::size_t(stride_) * std::size_t(size_.height + 2))),
        free_(std::size_t(stride_) * std::size_t(size_.height + 2), 0),
        labels_(size_.height + 2, stride_, 0) {
    tbb::parallel_for(0, size_.height, [&](int v) {
      const cv::Vec3f *p = frame.points[v], *n = normals.normals[v];
      const float* curvature = curvature_[v];
      Cell* cell = &cells_[std::size_t(index(0, v))];
      std::uint8_t* is_free = &free_[std::size_t(index(0, v))];
      for (int u = 0, end = size_.width; u < end; ++u) {
        cell[u] = {{p[u][0], p[u][1], p[u][2]}, {n[u][0], n[u][1], n[u][2]}};
        is_free[u] = curvature[u] < 1;
      }
    });
  }

  /// From all pixels with a normal, flattest first; ties in row-major order.
  LabelledPatches grow_all() {
    // Most of a frame is taken by patches that grow from the flattest pixels; only what they leave need be sorted.
    const int flat = flat_bins();
    grow_from_seeds(0, flat);
    grow_from_seeds(flat, bins);
    return {labels_(cv::Rect({1, 1}, size_)).clone(), count_};
  }

 private:
  struct alignas(32) Cell {  // two to a cache line
    Eigen::Vector3f point, normal;
  };

  static constexpr int bins = 4096;

  int index(int u, int v) const { return (v + 1) * stride_ + u + 1; }

  /// Of the curvature. Flat surfaces differ by far less than 1/3 over bins: the square root spreads them.
  static int bin(float curvature) { return std::min(bins - 1, int(std::sqrt(curvature * 3) * bins)); }

  /// The bins of about the flattest eighth of the pixels, by a sample of them.
  int flat_bins() const {
    std::vector<int> sample;
    const float* curvature = curvature_.ptr<float>();
    for (std::size_t i = 0; i < curvature_.total(); i += 61)
      if (curvature[i] < 1) sample.push_back(bin(curvature[i]));
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
    for (int v = 0; v < size_.height; ++v) {
      const float* curvature = curvature_[v];
      const std::uint8_t* is_free = &free_[std::size_t(index(0, v))];
      for (int u = 0; u < size_.width; ++u) {
        if (!is_free[u] || curvature[u] > limit) continue;
        const int own = bin(curvature[u]);
        if (own < first_bin || own >= end_bin) continue;
        found.emplace_back(own, index(u, v));
        ++start[std::size_t(own) + 1];
      }
    }
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int> seeds(found.size());
    for (const auto& [own, pixel] : found) seeds[std::size_t(start[std::size_t(own)]++)] = pixel;
    for (const int seed : seeds)
      if (free_[std::size_t(seed)]) grow(seed);
  }

  void grow(int seed) {
    front_.assign(1, seed);
    refused_.clear();
    free_[std::size_t(seed)] = 0;
    RunningPlane plane;
    plane.sum(cells_[std::size_t(seed)].point, cells_[std::size_t(seed)].normal);
    plane.update();
    double next_update = 0;
    const auto ask_neighbours = [&](int pixel) {
      bool refused = false;
      for (const int q : {pixel - 1, pixel + 1, pixel - stride_, pixel + stride_}) {
        if (!free_[std::size_t(q)]) continue;
        const auto& [p, n] = cells_[std::size_t(q)];
        if (plane.distance(p) > tolerances_.distance(p.z()) || n.dot(plane.normal) < tolerances_.cosine(p.z())) {
          refused = true;
          continue;
        }
        free_[std::size_t(q)] = 0;
        front_.push_back(q);
        plane.sum(p, n);
        // The mean of many hardly moves: it is updated when a 1024th is added.
        if (plane.count < next_update) continue;
        plane.update();
        next_update = plane.count * (1 + 1. / 1024);
      }
      return refused;
    };
    std::size_t asked = 0;
    for (; asked < front_.size(); ++asked)
      if (ask_neighbours(front_[asked])) refused_.push_back(front_[asked]);
    // The plane of a young patch wobbles and turns pixels away that belong to it: once it has settled, all are asked
    // again.
    for (const int pixel : refused_) ask_neighbours(pixel);
    for (; asked < front_.size(); ++asked) ask_neighbours(front_[asked]);
    const bool is_patch = int(front_.size()) >= smallest_;
    count_ += is_patch;
    int* labels = labels_.ptr<int>();
    for (const int pixel : front_)
      if (is_patch)
        labels[pixel] = count_;
      else
        free_[std::size_t(pixel)] = 1;
  }

  const cv::Size size_;
  const int stride_;
  const cv::Mat_<float> curvature_;
  const int smallest_;
  ToleranceMemory tolerances_;
  const std::unique_ptr<Cell[]> cells_;
  std::vector<std::uint8_t> free_;  // has a normal and is in no patch yet
  cv::Mat_<int> labels_;
  int count_ = 0;
  std::vector<int> front_;
  std::vector<int> refused_;  // of the front, those beside a pixel that was turned away
};

}  // namespace

LabelledPatches grow_patches(const Frame& frame, const NormalMap& normals, const Tolerances& tolerances) {
  return Growing(frame, normals, tolerances).grow_all();
}

}  // namespace gestalt
