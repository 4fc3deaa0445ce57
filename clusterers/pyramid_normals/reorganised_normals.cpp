// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "reorganised_normals.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cstring>

#include "vector_planes.h"

namespace gestalt {

namespace {

constexpr float still = 0.001f;  // a normal that moves less has come to rest

template <class F>
GESTALT_INLINE void dot(const Vector<F>& a, const Vector<F>& b, F& product) {
  product = a.x * b.x + a.y * b.y + a.z * b.z;
}

template <class F>
GESTALT_INLINE void squared_distance(const Vector<F>& a, const Vector<F>& b, F& squared) {
  const Vector<F> d{a.x - b.x, a.y - b.y, a.z - b.z};
  dot(d, d, squared);
}

/// What every round looks at.
struct Neighbourhood {
  VectorPlanes points;
  VectorPlanes normals;        // before the first round
  cv::Mat_<float> has_normal;  // 1 or 0
  cv::Mat_<float> squared_reach;
  float alpha, beta;
};

/// The pixels from (-before_du, -before_dv) to (after_du, after_dv), relative to one.
struct Window {
  int before_du, after_du, before_dv, after_dv;
};

/// One round for pixel (u, v), or for that and those to the right of it. moved: 1 where the normal has not come to
/// rest.
template <class F>
GESTALT_INLINE void pull(const Neighbourhood& in, const VectorPlanes& current, int u, int v, const Window& window,
                         VectorPlanes& next, F& moved) {
  const F zero{}, one = zero + 1;
  const auto load = [](const cv::Mat_<float>& plane, int x, int y, F& value) {
    std::memcpy(&value, &plane(y, x), sizeof value);
  };
  Vector<F> point, own, sum;
  F reach;
  in.points.load(u, v, point);
  current.load(u, v, own);
  load(in.squared_reach, u, v, reach);
  for (int dv = -window.before_dv; dv <= window.after_dv; ++dv)
    for (int du = -window.before_du; du <= window.after_du; ++du) {
      if (du == 0 && dv == 0) continue;
      Vector<F> neighbour, other;
      F weight, away, unlike;
      in.points.load(u + du, v + dv, neighbour);
      current.load(u + du, v + dv, other);
      load(in.has_normal, u + du, v + dv, weight);
      squared_distance(neighbour, point, away);
      weight = away > reach * float(du * du + dv * dv) ? zero : weight;
      squared_distance(own, other, unlike);
      const F like = in.beta / (unlike + in.beta);
      weight *= like * like;
      sum.x += weight * other.x, sum.y += weight * other.y, sum.z += weight * other.z;
    }
  Vector<F> pulled;
  in.normals.load(u, v, pulled);
  pulled.x += in.alpha * sum.x, pulled.y += in.alpha * sum.y, pulled.z += in.alpha * sum.z;
  F length, along, turns, way;
  dot(pulled, pulled, length);
  take_root(length);
  // One that would turn from the camera stays as it was, and so does a pixel without.
  load(in.has_normal, u, v, turns);
  turns = length > zero ? turns : zero;
  dot(pulled, point, along);
  turns = along < zero ? turns : zero;
  const F scale = one / length;
  const Vector<F> turned{turns > zero ? pulled.x * scale : own.x, turns > zero ? pulled.y * scale : own.y,
                         turns > zero ? pulled.z * scale : own.z};
  next.store(u, v, turned);
  squared_distance(turned, own, way);
  moved = way > zero + still * still ? one : zero;
}

void pull_normals(const Neighbourhood& in, const VectorPlanes& current, int u, int v, const Window& window,
                  VectorPlanes& next, float& moved) {
  pull(in, current, u, v, window, next, moved);
}

GESTALT_WIDE void pull_normals(const Neighbourhood& in, const VectorPlanes& current, int u, int v, const Window& window,
                               VectorPlanes& next, WideFloats& moved) {
  pull(in, current, u, v, window, next, moved);
}

class Reorganisation {
 public:
  Reorganisation(const Frame& frame, const NormalMap& map, const Tolerances& tolerances,
                 const ReorganisationParams& params)
      : width_(frame.width()),
        height_(frame.height()),
        radius_(params.reorganisation_radius),
        in_{VectorPlanes(frame.points),
            VectorPlanes(map.normals),
            cv::Mat_<float>(frame.depth.size(), 0.f),
            cv::Mat_<float>(frame.depth.size(), 0.f),
            float(params.neighbour_weight),
            float(params.likeness)},
        current_(map.normals),
        next_(map.normals) {
    for (int v = 0; v < height_; ++v)
      for (int u = 0; u < width_; ++u)
        if (map.curvature(v, u) < 1) {
          in_.has_normal(v, u) = 1;
          in_.squared_reach(v, u) = tolerances.squared_reach(frame.depth(v, u));
        }
  }

  /// False when all normals have come to rest.
  bool next_round() {
    std::atomic<bool> moved = false;
    tbb::parallel_for(tbb::blocked_range<int>(0, height_, 8), [&](const tbb::blocked_range<int>& rows) {
      bool any = false;
      for (int v = rows.begin(); v < rows.end(); ++v)
        for (int u = 0; u < width_;)
          if (u >= radius_ && u + wide_lanes + radius_ <= width_) {
            WideFloats lanes;
            pull_normals(in_, current_, u, v, window(u, u + wide_lanes - 1, v), next_, lanes);
            for (int i = 0; i < wide_lanes; ++i) any |= lanes[i] > 0;
            u += wide_lanes;
          } else {
            float alone;
            pull_normals(in_, current_, u, v, window(u, u, v), next_, alone);
            any |= alone > 0;
            ++u;
          }
      if (any) moved = true;
    });
    std::swap(current_, next_);
    return moved;
  }

  cv::Mat_<cv::Vec3f> normals() const {
    cv::Mat_<cv::Vec3f> merged;
    cv::merge(current_.coordinates.data(), current_.coordinates.size(), merged);
    return merged;
  }

 private:
  /// As far as the image goes around the pixels (first_u, v) to (last_u, v).
  Window window(int first_u, int last_u, int v) const {
    return {std::min(radius_, first_u), std::min(radius_, width_ - 1 - last_u), std::min(radius_, v),
            std::min(radius_, height_ - 1 - v)};
  }

  const int width_, height_, radius_;
  Neighbourhood in_;
  VectorPlanes current_, next_;
};

}  // namespace

NormalMap reorganise(const Frame& frame, NormalMap map, const Tolerances& tolerances,
                     const ReorganisationParams& params) {
  Reorganisation reorganisation(frame, map, tolerances, params);
  for (int round = 0; round < params.rounds && reorganisation.next_round(); ++round) {
  }
  map.normals = reorganisation.normals();
  return map;
}

}  // namespace gestalt
