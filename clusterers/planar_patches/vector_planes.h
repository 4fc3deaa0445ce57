// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cstring>
#include <opencv2/core.hpp>

#include "gestalt/core/base/wide.h"

namespace gestalt {

/// Of one pixel, or of several. F: float or WideFloats.
template <class F>
struct Vector {
  F x{}, y{}, z{};
};

/// The vectors of an image, a plane for each coordinate: those of neighbouring pixels are loaded together.
struct VectorPlanes {
  explicit VectorPlanes(const cv::Mat_<cv::Vec3f>& vectors) { cv::split(vectors, coordinates.data()); }

  /// Of pixel (u, v), or of that and those to the right of it.
  template <class F>
  GESTALT_INLINE void load(int u, int v, Vector<F>& vector) const {
    std::memcpy(&vector.x, &coordinates[0](v, u), sizeof(F));
    std::memcpy(&vector.y, &coordinates[1](v, u), sizeof(F));
    std::memcpy(&vector.z, &coordinates[2](v, u), sizeof(F));
  }

  template <class F>
  GESTALT_INLINE void store(int u, int v, const Vector<F>& vector) {
    std::memcpy(&coordinates[0](v, u), &vector.x, sizeof(F));
    std::memcpy(&coordinates[1](v, u), &vector.y, sizeof(F));
    std::memcpy(&coordinates[2](v, u), &vector.z, sizeof(F));
  }

  std::array<cv::Mat_<float>, 3> coordinates;
};

}  // namespace gestalt
