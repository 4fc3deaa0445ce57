// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>

#include "gestalt/core/plugin/parameters.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// How far from each other the points and normals of one surface may be, in terms that hold for any camera: sigma is
/// the sensor's noise at the depth of a point, the footprint of a pixel is what it covers there, z / f. Pixel numbers
/// are for a focal length of 525 px, the Kinect's at 640x480, and grow and shrink with the focal length.
///
/// The defaults give, for a Kinect between 0.7 and 1.3 m, about the thresholds of the authors' published program: a
/// distance of -0.002 + 0.015 z m, an angle of 0.58 + 0.1 z rad, a window of 3 px below 2 m and 1 px more for each 0.5
/// m.
struct ToleranceParams {
  double window_radius = 3;       ///< px at 525 px focal length: least radius of the neighbourhood of a normal
  double window_noise = 2;        ///< in any case that radius spans this many sigma
  double neighbour_slope = 2.69;  ///< steepest surface whose pixels are neighbours: footprints of depth for each pixel
  double angle = 0.485;           ///< rad: eps(z) = angle + angle_noise * sigma / (the window's radius in metres)
  double angle_noise = 0.59;
  double distance = 0;  ///< m: omega(z) = distance + distance_noise * sigma
  double distance_noise = 6.7;
  double min_patch_size = 9;    ///< px at 525 px focal length
  double spur_radius = 2;       ///< px at 525 px focal length; 0 leaves spurs where they are
  double spur_distance = 0.75;  ///< in omega(z)
  double smallest_island = 30;  ///< px at 525 px focal length
  double island_distance = 4;   ///< in omega(z)
};

/// Adds the declarations to those of a component whose Params derive from ToleranceParams.
template <class Params>
Parameters<Params>& declare_tolerances(Parameters<Params>& parameters) {
  const auto real = [&](const char* name, double ToleranceParams::*member, double low, double high, const char* unit,
                        const char* text) {
    parameters.real(name, static_cast<double Params::*>(member), low, high, unit, text);
  };
  using P = ToleranceParams;
  real("window_radius", &P::window_radius, 1, 50, "px",
       "least radius of the neighbourhood of a normal, for f = 525 px");
  real("window_noise", &P::window_noise, 0, 1000, "", "that radius spans at least this many sigma(z)");
  real("neighbour_slope", &P::neighbour_slope, 0.05, 1000, "",
       "a point r px away is a neighbour when it is nearer than this * r * z / f");
  real("angle", &P::angle, 0, 3.2, "rad",
       "largest angle of a pixel's normal to its patch's mean normal, without noise");
  real("angle_noise", &P::angle_noise, 0, 100, "rad", "and this for each sigma(z) in a window's radius");
  real("distance", &P::distance, 0, 10, "m", "largest distance of a pixel to its patch's plane, without noise");
  real("distance_noise", &P::distance_noise, 0, 1000, "", "and this many sigma(z)");
  real("min_patch_size", &P::min_patch_size, 1, 1000, "px",
       "smaller patches are dissolved and their pixels clustered by connectivity, for f = 525 px");
  real("spur_radius", &P::spur_radius, 0, 50, "px",
       "strips thinner than twice this and a pixel go to the patches beside them, for f = 525 px");
  real("spur_distance", &P::spur_distance, 0, 1000, "",
       "a left-over pixel joins a patch that it touches within this part of the largest distance to a plane");
  real("smallest_island", &P::smallest_island, 0, 1e6, "px",
       "smaller left-over components join a patch beside them, or none, for f = 525 px");
  real("island_distance", &P::island_distance, 0, 1000, "",
       "largest depth difference to that patch, in largest distances to a plane");
  return parameters;
}

/// ToleranceParams for one frame. z is a depth in metres, > 0; lengths are in metres.
class Tolerances {
 public:
  Tolerances(const Frame& frame, const ToleranceParams& params);

  /// Those of the frame at half its resolution: footprints are twice as large, numbers of pixels are the same.
  Tolerances halved() const;

  /// Pixels that the neighbourhood of a normal extends to each side, at least 1.
  int window_radius(float z) const;

  /// Of the rows and columns of that neighbourhood one in so many is enough: 1 up to about 800 px of focal length.
  int window_step() const { return std::max(1, int(std::lround(scale_))); }

  /// Largest distance, squared, of a neighbour one pixel away; of one r pixels away r^2 times that.
  float squared_reach(float z) const;

  /// omega(z) of Section 3.
  float distance(float z) const;

  /// Cosine of eps(z) of Section 3.
  float cosine(float z) const;

  /// Largest distance of a left-over pixel to one of the patch that it joins.
  float spur_distance(float z) const { return float(params_.spur_distance) * distance(z); }

  /// Largest depth difference of an island to the patch that it sinks into.
  float island_distance(float z) const { return float(params_.island_distance) * distance(z); }

  int spur_radius() const;      ///< px, 0 = leave spurs
  int min_patch_size() const;   ///< px, at least 1
  int smallest_island() const;  ///< px

 private:
  /// sigma(z) in footprints.
  double noise_in_pixels(float z) const;

  ToleranceParams params_;
  DepthNoise noise_;
  double focal_length_;  ///< px
  double scale_;         ///< of pixel lengths
};

}  // namespace gestalt
