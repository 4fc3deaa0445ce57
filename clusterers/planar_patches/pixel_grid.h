// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "gestalt/core/scene/frame.h"
#include "normal_estimation.h"

namespace gestalt {

/// Points and normals of a frame by row-major pixel index. Keeps pointers to them.
class PixelGrid {
 public:
  PixelGrid(const Frame& frame, const NormalMap& normals)
      : points_(frame.points.ptr<cv::Vec3f>()),
        depth_(frame.depth.ptr<float>()),
        normals_(normals.normals.ptr<cv::Vec3f>()),
        curvature_(normals.curvature.ptr<float>()),
        width_(frame.width()),
        size_(int(frame.depth.total())) {}

  int size() const { return size_; }
  bool valid(int pixel) const { return depth_[pixel] > 0; }
  float depth(int pixel) const { return depth_[pixel]; }
  Eigen::Vector3f point(int pixel) const { return vector(points_[pixel]); }
  bool has_normal(int pixel) const { return curvature_[pixel] < 1; }

  /// (0, 0, 0) where there is none.
  Eigen::Vector3f normal(int pixel) const { return vector(normals_[pixel]); }

  /// Calls f with the pixels to the left, right, above and below, as far as the image goes.
  template <class F>
  void for_neighbours_4(int pixel, F f) const {
    const int u = pixel % width_;
    if (u > 0) f(pixel - 1);
    if (u + 1 < width_) f(pixel + 1);
    if (pixel >= width_) f(pixel - width_);
    if (pixel + width_ < size_) f(pixel + width_);
  }

 private:
  static Eigen::Vector3f vector(const cv::Vec3f& v) { return {v[0], v[1], v[2]}; }

  const cv::Vec3f* const points_;
  const float* const depth_;
  const cv::Vec3f* const normals_;
  const float* const curvature_;
  const int width_;
  const int size_;
};

}  // namespace gestalt
