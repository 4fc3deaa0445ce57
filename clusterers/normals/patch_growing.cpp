// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_growing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <queue>
#include <tuple>
#include <vector>

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

/// Mean point and mean normal of a growing patch.
struct RunningPlane {
  Eigen::Vector3d point_sum = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal_sum = Eigen::Vector3d::Zero();
  double count = 0;
  Eigen::Vector3f normal = Eigen::Vector3f::Zero();
  float offset = 0;

  void add(const Eigen::Vector3f& point, const Eigen::Vector3f& n) {
    sum(point, n);
    update();
  }
  void sum(const Eigen::Vector3f& point, const Eigen::Vector3f& n) {
    point_sum += point.cast<double>();
    normal_sum += n.cast<double>();
    count += 1;
  }
  void update() {
    normal = normal_sum.normalized().cast<float>();
    offset = -float(normal_sum.normalized().dot(point_sum) / count);
  }
  float distance(const Eigen::Vector3f& p) const { return std::abs(normal.dot(p) + offset); }
};

class Growing {
 public:
  Growing(const Frame& frame, const NormalMap& normals, const GrowingParams& params)
      : frame_(frame), normals_(normals), params_(params), width_(frame.width()), labels_(frame.depth.size(), 0) {}

  void grow_from_seeds() {
    for (const int seed : seeds_by_curvature(normals_)) {
      if (label(seed) != 0) continue;
      grow(seed);
    }
  }

  /// Takes from every patch what a square of 2 * spur_radius + 1 pixels within it cannot reach: strips along creases
  /// and depth jumps, where a normal mixes two surfaces, and the thin ends of patches that crept along them.
  void cut_spurs() {
    const int radius = params_.spur_radius;
    if (radius == 0) return;
    const cv::Mat_<int> before = labels_.clone();
    const cv::Mat_<std::uint8_t> core = cores(radius);
    labels_.setTo(0);
    for (int v = 0; v < labels_.rows; ++v)
      for (int u = 0; u < labels_.cols; ++u) {
        if (!core(v, u)) continue;
        for (int dv = -radius; dv <= radius; ++dv) {
          const int* row = before[v + dv];
          std::copy(row + u - radius, row + u + radius + 1, labels_[v + dv] + u - radius);
        }
      }
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
      if (label(to) != 0 || !frame_.valid(to)) return;
      const Eigen::Vector3f p = frame_.point(to);
      if ((p - frame_.point(from)).norm() > float(params_.spur_distance)) return;
      const float distance = planes[std::size_t(label(from))].distance(p);
      if (distance <= omega(p.z())) offers.push({distance, to, label(from)});
    };
    for (int p = 0; p < int(labels_.total()); ++p)
      if (label(p) == 0 && frame_.valid(p))
        for_neighbours_4(p, [&](int q) {
          if (label(q) != 0) offer(q, p);
        });
    while (!offers.empty()) {
      const Offer best = offers.top();
      offers.pop();
      if (label(best.pixel) != 0) continue;
      label(best.pixel) = best.patch;
      for_neighbours_4(best.pixel, [&](int q) { offer(best.pixel, q); });
    }
  }

  /// Clusters what is still in no patch by connectivity; depth jumps separate.
  void gather_leftovers() {
    for (int seed = 0; seed < int(labels_.total()); ++seed) {
      if (label(seed) != 0 || !frame_.valid(seed)) continue;
      ++count_;
      front_.assign(1, seed);
      label(seed) = count_;
      for (std::size_t i = 0; i < front_.size(); ++i)
        for_neighbours_4(front_[i], [&](int q) {
          if (label(q) != 0 || !frame_.valid(q)) return;
          const float z = depth(front_[i]);
          if (std::abs(z - depth(q)) > omega(z)) return;
          label(q) = count_;
          front_.push_back(q);
        });
    }
  }

  /// Gives islands, left-over components of less than smallest_island pixels, to the patch of the touching pixel that
  /// is nearest in depth: too small to be related to anything, they are noise of the patch around them.
  void sink_islands(int first_island) {
    std::vector<std::vector<int>> islands(std::size_t(count_ - first_island + 1));
    for (int p = 0; p < int(labels_.total()); ++p)
      if (label(p) >= first_island) islands[std::size_t(label(p) - first_island)].push_back(p);
    const auto sinks = [&](int island_label) {
      return island_label >= first_island &&
             int(islands[std::size_t(island_label - first_island)].size()) < params_.smallest_island;
    };
    for (const std::vector<int>& island : islands) {
      if (int(island.size()) >= params_.smallest_island) continue;
      int nearest = 0;
      float gap = float(params_.island_distance);
      for (const int p : island)
        for_neighbours_4(p, [&](int q) {
          const float d = std::abs(depth(p) - depth(q));
          if (label(q) == 0 || sinks(label(q)) || d > gap) return;
          gap = d;
          nearest = label(q);
        });
      for (const int p : island) label(p) = nearest;
    }
  }

  int count() const { return count_; }

  /// Labels without gaps.
  cv::Mat_<int> finish(int& count) {
    std::vector<int> number(std::size_t(count_) + 1, 0);
    for (int p = 0; p < int(labels_.total()); ++p) number[std::size_t(label(p))] = 1;
    number[0] = 0;
    std::partial_sum(number.begin(), number.end(), number.begin());
    for (int p = 0; p < int(labels_.total()); ++p)
      if (label(p) != 0) label(p) = number[std::size_t(label(p))];
    count = number.back();
    return labels_;
  }

 private:
  int& label(int pixel) { return labels_.ptr<int>()[pixel]; }
  float depth(int pixel) const { return frame_.depth.ptr<float>()[pixel]; }
  float omega(float z) const { return float(params_.distance + params_.distance_per_metre * z); }
  Eigen::Vector3f normal(int pixel) const {
    const cv::Vec3f& n = normals_.normals.ptr<cv::Vec3f>()[pixel];
    return {n[0], n[1], n[2]};
  }

  /// Marks the pixels around which the whole square is of one patch.
  cv::Mat_<std::uint8_t> cores(int radius) const {
    const int side = 2 * radius + 1;
    // run: how many pixels to the left, including this one, are of one patch; stack: how many rows above have full
    // runs.
    cv::Mat_<std::uint8_t> core(labels_.size(), std::uint8_t{0});
    std::vector<int> stack(std::size_t(width_), 0);
    for (int v = 0; v < labels_.rows; ++v) {
      const int* row = labels_[v];
      const int* above = v > 0 ? labels_[v - 1] : nullptr;
      int run = 0;
      for (int u = 0; u < width_; ++u) {
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
    std::vector<RunningPlane> planes(std::size_t(count_) + 1);
    for (int p = 0; p < int(labels_.total()); ++p)
      if (const int own = labels_.ptr<int>()[p]; own != 0) planes[std::size_t(own)].sum(frame_.point(p), normal(p));
    for (RunningPlane& plane : planes)
      if (plane.count > 0) plane.update();
    return planes;
  }

  void grow(int seed) {
    RunningPlane plane;
    const int own = ++count_;
    front_.assign(1, seed);
    label(seed) = own;
    plane.add(frame_.point(seed), normal(seed));
    // The plane of a young patch wobbles and turns pixels away that belong to it: once it has settled, all are asked
    // again.
    for (int round = 0; round < 2; ++round)
      for (std::size_t i = 0; i < front_.size(); ++i)
        for_neighbours_4(front_[i], [&](int q) {
          if (label(q) != 0 || !(normals_.curvature.ptr<float>()[q] < 1)) return;
          const Eigen::Vector3f p = frame_.point(q), n = normal(q);
          const float cosine =
              std::cos(std::clamp(float(params_.angle + params_.angle_per_metre * p.z()), 0.f, 3.14159265f));
          if (n.dot(plane.normal) < cosine || plane.distance(p) > omega(p.z())) return;
          label(q) = own;
          plane.add(p, n);
          front_.push_back(q);
        });
    if (int(front_.size()) >= params_.min_patch_size) return;
    for (const int pixel : front_) label(pixel) = 0;
    --count_;
  }

  template <class F>
  void for_neighbours_4(int p, F f) const {
    const int u = p % width_;
    if (u > 0) f(p - 1);
    if (u + 1 < width_) f(p + 1);
    if (p >= width_) f(p - width_);
    if (p + width_ < int(labels_.total())) f(p + width_);
  }

  const Frame& frame_;
  const NormalMap& normals_;
  const GrowingParams& params_;
  const int width_;
  cv::Mat_<int> labels_;
  int count_ = 0;
  std::vector<int> front_;
};

}  // namespace

cv::Mat_<int> grow_patches(const Frame& frame, const NormalMap& normals, const GrowingParams& params, int& count) {
  Growing growing(frame, normals, params);
  growing.grow_from_seeds();
  growing.cut_spurs();
  growing.reassign_leftovers();
  const int patches = growing.count();
  growing.gather_leftovers();
  growing.sink_islands(patches + 1);
  return growing.finish(count);
}

}  // namespace gestalt
