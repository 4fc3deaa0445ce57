// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "neighbour_moments.h"

namespace gestalt {

/// The normal of the least-squares plane through a point's neighbours. F: one pixel's or those of several.
template <class F>
struct LeastSquaresNormal {
  F x{}, y{}, z{};  ///< unit, towards the camera
  F curvature{};    ///< smallest eigenvalue over the sum of all three, in [0, 1/3]
};

/// point is what the moments are relative to, in the camera's frame. With fewer than three neighbours, neighbours on a
/// line or in one place, and planes seen edge-on the normal is (0, 0, 0) and the curvature 1.
void find_normal(const NeighbourMoments<float>& moments, const Vector<float>& point, LeastSquaresNormal<float>& normal);

/// The same lane by lane, to the last bit.
void find_normal(const NeighbourMoments<WideFloats>& moments, const Vector<WideFloats>& point,
                 LeastSquaresNormal<WideFloats>& normal);

}  // namespace gestalt
