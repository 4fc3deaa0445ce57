// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "normal_estimation.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "least_squares_normal.h"

namespace gestalt {

namespace {

constexpr int full_window = 8;  // px at 525 px focal length; larger ones are sampled

class Estimation {
 public:
  Estimation(const Frame& frame, const Tolerances& tolerances)
      : frame_(frame),
        tolerances_(tolerances),
        points_(frame.points),
        map_{cv::Mat_<cv::Vec3f>(frame.depth.size(), cv::Vec3f()), cv::Mat_<float>(frame.depth.size(), 1.f)} {}

  NormalMap run() {
    tbb::parallel_for(tbb::blocked_range<int>(0, frame_.height(), 8), [&](const tbb::blocked_range<int>& rows) {
      for (int v = rows.begin(); v < rows.end(); ++v)
        for (int u = 0; u < frame_.width(); u += wide_lanes) estimate_lanes(u, v);
    });
    return std::move(map_);
  }

 private:
  /// Of the pixels from (u, v) on that are in the image and have depth. Those of equal windows are summed together.
  void estimate_lanes(int u, int v) {
    std::array<int, wide_lanes> radius{};  // 0: done, or nothing to do
    WideFloats reach{};
    for (int i = 0; i < std::min(wide_lanes, frame_.width() - u); ++i)
      if (const float z = frame_.depth(v, u + i); z > 0) {
        radius[std::size_t(i)] = tolerances_.window_radius(z);
        reach[i] = tolerances_.squared_reach(z);
      }
    for (int i = 0; i < wide_lanes; ++i) {
      const int own = radius[std::size_t(i)];
      if (own == 0) continue;
      if (u < own || u + wide_lanes + own > frame_.width()) {  // a window, or the lanes, leave the image
        const LeastSquaresNormal<float> n = estimate(u + i, v, own, reach[i]);
        set_normal(u + i, v, n.x, n.y, n.z, n.curvature);
        continue;
      }
      const LeastSquaresNormal<WideFloats> n = estimate(u, v, own, reach);
      for (int k = i; k < wide_lanes; ++k)
        if (radius[std::size_t(k)] == own) {
          set_normal(u + k, v, n.x[k], n.y[k], n.z[k], n.curvature[k]);
          radius[std::size_t(k)] = 0;
        }
    }
  }

  NeighbourWindow window(int u, int v, int radius) const {
    // Noise is shared by neighbouring pixels: of a large window a sample tells as much. A window that is large because
    // the camera has many pixels is looked at as one of a Kinect would be.
    const int step = std::max(1 + (radius - 1) / full_window, tolerances_.window_step());
    const auto first = [&](int room) { return -(std::min(radius, room) / step * step); };
    return {first(u), std::min(radius, frame_.width() - 1 - u), first(v), std::min(radius, frame_.height() - 1 - v),
            step};
  }

  /// F: of pixel (u, v), or of that and those to the right of it.
  template <class F>
  LeastSquaresNormal<F> estimate(int u, int v, int radius, const F& squared_reach) const {
    NeighbourMoments<F> moments;
    sum_neighbours(points_, u, v, window(u, v, radius), squared_reach, moments);
    Vector<F> point;
    points_.load(u, v, point);
    LeastSquaresNormal<F> normal;
    find_normal(moments, point, normal);
    return normal;
  }

  void set_normal(int u, int v, float x, float y, float z, float curvature) {
    map_.normals(v, u) = {x, y, z};
    map_.curvature(v, u) = curvature;
  }

  const Frame& frame_;
  const Tolerances& tolerances_;
  const VectorPlanes points_;
  NormalMap map_;
};

}  // namespace

NormalMap estimate_normals(const Frame& frame, const Tolerances& tolerances) {
  return Estimation(frame, tolerances).run();
}

}  // namespace gestalt
