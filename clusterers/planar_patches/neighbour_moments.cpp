// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause

#include "neighbour_moments.h"

namespace gestalt {

namespace {

template <class F>
GESTALT_INLINE void sum(const VectorPlanes& points, int u, int v, const NeighbourWindow& window, const F& squared_reach,
                        NeighbourMoments<F>& moments) {
  Vector<F> p;
  points.load(u, v, p);
  const F one = F{} + 1, zero{};
  NeighbourMoments<F> m;
  for (int dv = window.first_dv; dv <= window.last_dv; dv += window.step) {
    for (int du = window.first_du; du <= window.last_du; du += window.step) {
      Vector<F> q;
      points.load(u + du, v + dv, q);
      const F dx = q.x - p.x, dy = q.y - p.y, dz = q.z - p.z;
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

void sum_neighbours(const VectorPlanes& points, int u, int v, const NeighbourWindow& window, const float& squared_reach,
                    NeighbourMoments<float>& moments) {
  sum(points, u, v, window, squared_reach, moments);
}

GESTALT_WIDE void sum_neighbours(const VectorPlanes& points, int u, int v, const NeighbourWindow& window,
                                 const WideFloats& squared_reach, NeighbourMoments<WideFloats>& moments) {
  sum(points, u, v, window, squared_reach, moments);
}

}  // namespace gestalt
