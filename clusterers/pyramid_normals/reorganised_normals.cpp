// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reorganised_normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>

namespace gestalt {

namespace {

constexpr float still = 0.001f;  // a normal that moves less has come to rest

float squared_distance(const cv::Vec3f& a, const cv::Vec3f& b) {
  const cv::Vec3f d = a - b;
  return d.dot(d);
}

}  // namespace

NormalMap reorganise(const Frame& frame, NormalMap map, const Tolerances& tolerances,
                     const ReorganisationParams& params) {
  const int width = frame.width(), height = frame.height(), radius = params.reorganisation_radius;
  const auto alpha = float(params.neighbour_weight), beta = float(params.likeness);
  cv::Mat_<cv::Vec3f> current = map.normals.clone(), next = map.normals.clone();
  for (int round = 0; round < params.rounds; ++round) {
    std::atomic<bool> moved = false;
    tbb::parallel_for(tbb::blocked_range<int>(0, height, 8), [&](const tbb::blocked_range<int>& rows) {
      for (int v = rows.begin(); v < rows.end(); ++v)
        for (int u = 0; u < width; ++u) {
          if (!(map.curvature(v, u) < 1)) continue;
          const cv::Vec3f &own = current(v, u), &point = frame.points(v, u);
          const float reach = tolerances.squared_reach(frame.depth(v, u));
          cv::Vec3f sum;
          for (int dv = -std::min(radius, v); dv <= std::min(radius, height - 1 - v); ++dv)
            for (int du = -std::min(radius, u); du <= std::min(radius, width - 1 - u); ++du) {
              if ((du == 0 && dv == 0) || !(map.curvature(v + dv, u + du) < 1)) continue;
              if (squared_distance(frame.points(v + dv, u + du), point) > reach * float(du * du + dv * dv)) continue;
              const cv::Vec3f& other = current(v + dv, u + du);
              const float unlike = squared_distance(own, other), like = beta / (unlike + beta);
              sum += like * like * other;
            }
          const cv::Vec3f pulled = map.normals(v, u) + alpha * sum;
          const float length = std::sqrt(pulled.dot(pulled));
          // One that would turn from the camera stays as it was.
          next(v, u) = length > 0 && pulled.dot(point) < 0 ? pulled * (1 / length) : own;
          if (squared_distance(next(v, u), own) > still * still) moved = true;
        }
    });
    std::swap(current, next);
    if (!moved) break;
  }
  map.normals = current;
  return map;
}

}  // namespace gestalt
