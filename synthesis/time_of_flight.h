// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"
#include "measurement.h"
#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

// A camera that times its own modulated light: Azure Kinect, RealSense L515.

constexpr double time_of_flight_camera_x = -0.032;   ///< metres along the colour camera's x axis: Azure Kinect
constexpr double time_of_flight_focal_length = 504;  ///< pixels: Azure Kinect, narrow field, 640x576

/// Deviation of depth (metres) at z: 0.5 mm + 0.001 z, of the magnitude that Toelgyessy et al. find (Evaluation of
/// the Azure Kinect and its comparison to Kinect V1 and V2, Sensors 21, 2021).
double time_of_flight_deviation(double z);

/// How much farther (metres along the optical axis) each pixel appears for light that comes over another surface:
/// nothing at a concave crease, most some centimetres beside it. One reflection between Lambertian surfaces (Jimenez et
/// al., Modeling and correction of multipath interference in time of flight cameras, Image and Vision Computing 32,
/// 2014). On a grid of at most 64 columns, interpolated.
cv::Mat_<float> multipath(const IdealView& view, const Camera& camera);

/// Adds flying pixels at depth jumps, multipath, axial noise; no depth where little light comes back (dark, far,
/// grazing), in shadows, beside jumps and outside of the depth camera's field, a rectangle, octagon or disc in the
/// colour image. How much of each is drawn once a call.
Measurement measure_time_of_flight(const IdealView& view, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
