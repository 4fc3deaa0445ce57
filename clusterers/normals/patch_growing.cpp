// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "patch_growing.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
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
    point_sum += point.cast<double>();
    normal_sum += n.cast<double>();
    count += 1;
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

  /// Clusters what is in no patch by connectivity; depth jumps separate.
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

  /// Pixels with few 8-neighbours of their own patch go to the touching patch whose pixel is nearest.
  void move_spurs() {
    const cv::Mat_<int> before = labels_.clone();
    const float reach = float(params_.spur_distance);
    for (int p = 0; p < int(labels_.total()); ++p) {
      const int own = before.ptr<int>()[p];
      if (own == 0) continue;
      int equal = 0, nearest = 0;
      float nearest_distance = reach;
      for_neighbours_8(p, [&](int q) {
        const int other = before.ptr<int>()[q];
        if (other == own) ++equal;
        if (other == own || other == 0) return;
        const float d = (frame_.point(p) - frame_.point(q)).norm();
        if (d < nearest_distance || (d == nearest_distance && nearest == 0)) nearest_distance = d, nearest = other;
      });
      if (equal < params_.spur_neighbours && nearest != 0) label(p) = nearest;
    }
  }

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

  void grow(int seed) {
    RunningPlane plane;
    const int own = ++count_;
    front_.assign(1, seed);
    label(seed) = own;
    plane.add(frame_.point(seed), normal(seed));
    for (std::size_t i = 0; i < front_.size(); ++i)
      for_neighbours_4(front_[i], [&](int q) {
        if (label(q) != 0 || !(normals_.curvature.ptr<float>()[q] < 1)) return;
        const Eigen::Vector3f p = frame_.point(q), n = normal(q);
        const float cosine = std::cos(std::min(float(params_.angle + params_.angle_per_metre * p.z()), 3.14159265f));
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

  template <class F>
  void for_neighbours_8(int p, F f) const {
    const int u = p % width_, v = p / width_;
    for (int dv = v > 0 ? -1 : 0; dv <= (v + 1 < labels_.rows ? 1 : 0); ++dv)
      for (int du = u > 0 ? -1 : 0; du <= (u + 1 < width_ ? 1 : 0); ++du)
        if (dv != 0 || du != 0) f(p + dv * width_ + du);
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
  growing.gather_leftovers();
  growing.move_spurs();
  return growing.finish(count);
}

}  // namespace gestalt
