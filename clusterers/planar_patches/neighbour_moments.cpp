// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "neighbour_moments.h"

#include <cstring>

namespace gestalt {

namespace {

template <class F>
__attribute__((always_inline)) inline void sum(const PointPlanes& points, int u, int v, const NeighbourWindow& window,
                                               const F& squared_reach, NeighbourMoments<F>& moments) {
  const auto load = [](const float* from, F& to) { std::memcpy(&to, from, sizeof to); };
  F px, py, pz;
  load(&points.coordinates[0](v, u), px);
  load(&points.coordinates[1](v, u), py);
  load(&points.coordinates[2](v, u), pz);
  const F one = F{} + 1, zero{};
  NeighbourMoments<F> m;
  for (int dv = window.first_dv; dv <= window.last_dv; dv += window.step) {
    const float* x_row = points.coordinates[0][v + dv] + u;
    const float* y_row = points.coordinates[1][v + dv] + u;
    const float* z_row = points.coordinates[2][v + dv] + u;
    for (int du = window.first_du; du <= window.last_du; du += window.step) {
      F dx, dy, dz;
      load(x_row + du, dx);
      load(y_row + du, dy);
      load(z_row + du, dz);
      dx -= px, dy -= py, dz -= pz;
      const F counts = dx * dx + dy * dy + dz * dz <= squared_reach * float(du * du + dv * dv) ? one : zero;
      const F cx = counts * dx, cy = counts * dy, cz = counts * dz;
      m.n += counts;
      m.x += cx, m.y += cy, m.w += cz;
      m.xx += cx * dx, m.xy += cx * dy, m.xw += cx * dz;
      m.yy += cy * dy, m.yw += cy * dz, m.ww += cz * dz;
    }
  }
  moments = m;
}

}  // namespace

PointPlanes::PointPlanes(const cv::Mat_<cv::Vec3f>& points) { cv::split(points, coordinates.data()); }

void sum_neighbours(const PointPlanes& points, int u, int v, const NeighbourWindow& window, const float& squared_reach,
                    NeighbourMoments<float>& moments) {
  sum(points, u, v, window, squared_reach, moments);
}

GESTALT_WIDE void sum_neighbours(const PointPlanes& points, int u, int v, const NeighbourWindow& window,
                                 const WideFloats& squared_reach, NeighbourMoments<WideFloats>& moments) {
  sum(points, u, v, window, squared_reach, moments);
}

}  // namespace gestalt
