// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/scene/surface_set.h"

namespace gestalt {

/// A bank of Gabor filters: complex waves under a round Gaussian, for each scale in evenly turned directions.
struct GaborBank {
  int directions = 6;                    ///< direction j has its wave vector at angle pi j / directions from the x axis
  int scales = 5;                        ///< scale i has the wavelength shortest_wavelength * spacing^i
  double shortest_wavelength = 8.0 / 3;  ///< px
  double spacing = 1.224744871391589;    ///< ratio of neighbouring wavelengths, sqrt(1.5)
  double sigma = 6.283185307179586;  ///< standard deviation of the Gaussian times the wave number: here one wavelength
  double truncation = 3;             ///< radius of the kernel in standard deviations of the Gaussian
  int stride = 2;                    ///< px; responses are taken on every stride-th row and column

  std::size_t filters() const { return std::size_t(directions * scales); }
  double wave_number(int scale) const;  ///< rad/px
  double deviation(int scale) const;    ///< px, of the Gaussian
  int radius(int scale) const;          ///< px, of the kernel: 8, 10, 12, 15 and 18 by default
};

/// Every filter's magnitudes at the grid pixels of a box of the image, in grey levels: a wave of amplitude A that fits
/// a filter gives A / 2. Filter i * directions + j is scale i, direction j. Grid pixel (row, column) is image pixel
/// (row * stride, column * stride).
class GaborResponses {
 public:
  /// box: grid pixels, may be empty. Every kernel is free of DC, so that brightness does not count; the image is
  /// mirrored at its edge.
  GaborResponses(const GaborBank& bank, const cv::Mat& grey, const cv::Rect& box);

  const cv::Rect& box() const { return box_; }

  /// Of the grid pixels from (row, column) on, to the end of the box's row.
  const float* at(int row, std::size_t filter, int column) const {
    return magnitudes_[(row - box_.y) * filters_ + int(filter)] + (column - box_.x);
  }

 private:
  cv::Rect box_;
  int filters_;
  cv::Mat_<float> magnitudes_;  // rows: of each grid row, each filter
};

/// The grid pixels to which the pixels of a mask (CV_8UC1, not 0) belong: each belongs to that above and to the left of
/// it. Empty when there are none.
cv::Rect grid_box(const cv::Mat& mask, int stride);

/// Mean and standard deviation of every filter's magnitude over a surface's pixels.
struct GaborDescriptor {
  std::vector<float> mean;
  std::vector<float> deviation;
};

/// The descriptors of all surfaces, whose pixels' grid pixels must be in the responses' box. A surface without a pixel
/// on the grid of the stride takes for each pixel the grid pixel that it belongs to. The result is the same for any
/// number of threads.
std::vector<GaborDescriptor> describe(const GaborBank& bank, const GaborResponses& responses,
                                      const SurfaceSet& surfaces);

}  // namespace gestalt
