// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <set>
#include <vector>

#include "gestalt/core/scene/depth_noise.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// What was found of the noise in a range of depths.
struct NoiseBin {
  double depth = 0;         ///< m, the mean of its windows
  int windows = 0;          ///< planar windows that sigma is taken from
  std::size_t samples = 0;  ///< pixels in them, once for each window
  double sigma = 0;         ///< m, standard deviation of the readings about a plane
  double step = 0;          ///< m, to 0.1 mm: distance of two readings that the sensor tells apart
};

struct NoiseEstimate {
  DepthNoise noise;            ///< no coefficient is negative, so that it grows beyond the depths that were seen
  std::vector<NoiseBin> bins;  ///< by depth
};

/// Estimates sigma(z) of a sensor from frames that show planes at some places, of whatever else there is.
///
/// A plane's inverse depth is linear in the pixel (1/z = a u + b v + c). That is fitted to square windows all over the
/// frame, 3.7 degrees wide and half overlapping, and each gives the standard deviation of its readings about the plane.
/// In a bin of depths, windows of more than twice the lower quartile hold an edge or a curved surface and are left out;
/// the bin's sigma is the median of the others, and no less than that of the readings' steps, step / sqrt(12), where
/// all readings of a window may fall on one. sigma(z) is the polynomial nearest to the bins in relative error, weighted
/// by windows; windows of more than twice that are left out in turn, and it is fitted again.
class GESTALT_EXPORT NoiseCalibration {
 public:
  void add(const Frame& frame);

  /// Throws InputError when no bin has enough windows.
  NoiseEstimate estimate() const;

 private:
  struct Window {
    float depth;     // m
    float variance;  // m^2
    int samples;
  };
  struct Bin {
    std::vector<Window> windows;
    std::set<int> readings;  // in 0.1 mm
  };

  /// The bins with enough planar windows. known: sigma(z) as far as it is known, or null.
  std::vector<NoiseBin> bins(const DepthNoise* known) const;

  std::map<int, Bin> bins_;  // by number, from near to far
};

}  // namespace gestalt
