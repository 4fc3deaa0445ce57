// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <algorithm>
#include <opencv2/core.hpp>
#include <vector>

#include "random.h"

namespace gestalt::synthesis {

/// A picture on a surface.
struct Texture {
  cv::Mat_<cv::Vec3b> image;  ///< blue, green, red
  double texel = 0.001;       ///< metres

  /// Bilinear; repeats beyond its borders. at is in metres.
  cv::Vec3f sample(const Eigen::Vector2f& at) const;
};

/// One texture for each part of a mesh; parts beyond the last wear the last.
struct Paint {
  std::vector<Texture> parts;
  float gloss = 0;  ///< share of the lamp that it mirrors, 0-1
  const Texture& of(int part) const { return parts[std::min(std::size_t(part), parts.size() - 1)]; }
};

/// The colours that the prints of one object use.
struct Palette {
  cv::Vec3b ground, band, accent, ink;
};

Palette random_palette(Random& random);

/// Hardly to be told from another: two cartons of one brand.
Palette similar_palette(const Palette& palette, Random& random);

Texture plain(const cv::Vec3b& colour);

/// As on a carton or can: bands, blocks of colour, a picture, lettering, lines of small print. Size in metres.
Texture print(double width, double height, const Palette& palette, Random& random);

/// Blotches and bands of related colours, as on stoneware and wood.
Texture glaze(double width, double height, const Palette& palette, Random& random);

/// A table top with grain along x.
Texture wood(double width, double height, Random& random);

/// What lies behind the table, out of the sensor's range: a few large areas.
Texture room(double width, double height, Random& random);

}  // namespace gestalt::synthesis
