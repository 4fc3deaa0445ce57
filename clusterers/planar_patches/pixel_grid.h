// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#pragma once

#include <Eigen/Core>

#include "gestalt/frame.h"
#include "normal_estimation.h"

namespace gestalt {

/// Points and normals of a frame by row-major pixel index. Keeps references.
class PixelGrid {
 public:
  PixelGrid(const Frame& frame, const NormalMap& normals)
      : frame_(frame), normals_(normals), width_(frame.width()), size_(int(frame.depth.total())) {}

  int size() const { return size_; }
  bool valid(int pixel) const { return frame_.valid(pixel); }
  float depth(int pixel) const { return frame_.depth.ptr<float>()[pixel]; }
  Eigen::Vector3f point(int pixel) const { return frame_.point(pixel); }
  bool has_normal(int pixel) const { return normals_.curvature.ptr<float>()[pixel] < 1; }

  /// (0, 0, 0) where there is none.
  Eigen::Vector3f normal(int pixel) const {
    const cv::Vec3f& n = normals_.normals.ptr<cv::Vec3f>()[pixel];
    return {n[0], n[1], n[2]};
  }

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
  const Frame& frame_;
  const NormalMap& normals_;
  const int width_;
  const int size_;
};

}  // namespace gestalt
