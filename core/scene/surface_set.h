// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <memory>
#include <opencv2/core.hpp>
#include <string>
#include <vector>

#include "gestalt/core/scene/surface_model.h"

namespace gestalt {

/// A patch with its parametric model, after surface merging.
struct Surface {
  std::vector<int> pixels;                    ///< row-major pixel indices, ascending, not empty
  std::shared_ptr<const SurfaceModel> model;  ///< never null
  std::vector<std::string> refusals = {};     ///< by fitter, why it has no surface for these pixels; "" if it has one
};

/// Two touching pixels (8-neighbours) of two surfaces, as row-major indices.
struct PixelPair {
  int a;
  int b;
};

/// Two surfaces that touch in the image (2D neighbours), a < b.
/// border_3d holds those touching pixels that are also close in depth; when it is not empty the two are 3D neighbours.
struct Adjacency {
  int a;
  int b;
  std::vector<PixelPair> border_2d;  ///< in row-major order of the pixels, pixel .a in surface a; not empty
  std::vector<PixelPair> border_3d;  ///< subset of border_2d
};

/// Result of the primitive level: surfaces with models, borders and neighbours. Made by model selection.
struct SurfaceSet {
  cv::Mat_<int> labels;  ///< size of the frame; 0 = none, else 1 + index into surfaces
  std::vector<Surface> surfaces;
  std::vector<Adjacency> adjacencies;  ///< sorted by (a, b), one for each pair of 2D neighbours
};

}  // namespace gestalt
