// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// One closed boundary of a surface in the image: its outermost pixels, 8-connected, in order around it. A line of one
/// pixel's width is walked there and back.
struct Contour {
  std::vector<int> pixels;  ///< row-major indices, not empty, all in the surface
  bool hole = false;        ///< runs around a hole of the surface
};

/// The contours of every surface: outer ones and those of holes. Surfaces of one pixel have a contour of one pixel.
GESTALT_EXPORT std::vector<std::vector<Contour>> find_contours(const SurfaceSet& surfaces);

}  // namespace gestalt
