// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "half_resolution.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace gestalt {

namespace {

/// depths: ascending.
float mean_of_largest_group(const std::array<float, 4>& depths, int count, const Tolerances& tolerances) {
  float mean = 0;
  int largest = 0;
  for (int i = 0; i < count; ++i) {
    const float reach = tolerances.distance(depths[std::size_t(i)]);
    float sum = 0;
    int size = 0;
    for (int j = 0; j < count; ++j) {
      if (std::abs(depths[std::size_t(j)] - depths[std::size_t(i)]) > reach) continue;
      sum += depths[std::size_t(j)];
      ++size;
    }
    if (size <= largest) continue;
    largest = size;
    mean = sum / float(size);
  }
  return mean;
}

}  // namespace

Frame halve(const Frame& frame, const Tolerances& tolerances) {
  const Camera& c = frame.camera;
  // Pixel u of the half covers 2 u and 2 u + 1, and its centre is between them.
  Frame half;
  half.name = frame.name;
  half.noise = frame.noise;
  half.camera = {(c.width + 1) / 2, (c.height + 1) / 2, c.fx / 2, c.fy / 2, (c.cx - 0.5) / 2, (c.cy - 0.5) / 2};
  half.depth = cv::Mat_<float>(half.camera.height, half.camera.width, 0.f);
  half.points = cv::Mat_<cv::Vec3f>(half.depth.size(), cv::Vec3f());
  tbb::parallel_for(0, half.depth.rows, [&](int v) {
    for (int u = 0; u < half.depth.cols; ++u) {
      std::array<float, 4> depths;
      depths.fill(std::numeric_limits<float>::infinity());  // behind all others
      int count = 0;
      for (int y = 2 * v; y < std::min(2 * v + 2, frame.height()); ++y)
        for (int x = 2 * u; x < std::min(2 * u + 2, frame.width()); ++x)
          if (const float z = frame.depth(y, x); z > 0) depths[std::size_t(count++)] = z;
      if (count == 0) continue;
      std::sort(depths.begin(), depths.end());
      const float z = mean_of_largest_group(depths, count, tolerances);
      half.depth(v, u) = z;
      half.points(v, u) = {float((u - half.camera.cx) / half.camera.fx) * z,
                           float((v - half.camera.cy) / half.camera.fy) * z, z};
    }
  });
  return half;
}

}  // namespace gestalt
