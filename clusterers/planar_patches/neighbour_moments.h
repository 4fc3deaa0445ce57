// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vector_planes.h"

namespace gestalt {

/// The neighbourhood of a pixel: every step-th row and column within [first, last], relative to it.
struct NeighbourWindow {
  int first_du, last_du;
  int first_dv, last_dv;
  int step;
};

/// Sums over the neighbours of a pixel, of their coordinates relative to it. F: one pixel's or those of several.
template <class F>
struct NeighbourMoments {
  F n{}, x{}, y{}, w{}, xx{}, xy{}, xw{}, yy{}, yw{}, ww{};
};

/// Pixels of the window around (u, v), all in the image, that lie within reach: nearer than sqrt(squared_reach) times
/// their distance in pixels. A pixel without depth is the origin, and so out of reach.
void sum_neighbours(const VectorPlanes& points, int u, int v, const NeighbourWindow& window, const float& squared_reach,
                    NeighbourMoments<float>& moments);

/// The same of the pixels (u, v) to (u + wide_lanes - 1, v), to the last bit.
void sum_neighbours(const VectorPlanes& points, int u, int v, const NeighbourWindow& window,
                    const WideFloats& squared_reach, NeighbourMoments<WideFloats>& moments);

}  // namespace gestalt
