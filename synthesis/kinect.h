// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"
#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

// The structured-light sensor of the first Kinect.

constexpr double infrared_focal_length = 580;  ///< pixels (Khoshelham & Elberink 2012: 5.453 mm / 9.3 um = 586)
constexpr double disparity_step = 1.0 / 8;     ///< pixels: the sensor interpolates to an eighth
/// Of the measured disparity: half a step (Khoshelham & Elberink 2012, Eq. 9: sigma_z = 1.425e-3 z^2 m).
constexpr double disparity_deviation = disparity_step / 2;
constexpr double lateral_deviation = 0.8;  ///< pixels by which outlines wander (Nguyen, Izadi, Lovell 2012)

/// The distance of two depths that the sensor tells apart around z: 2.87e-3 z^2 m.
double depth_step(double z);

struct Measurement {
  cv::Mat_<std::uint16_t> depth;  ///< millimetres, 0 = no measurement
  cv::Mat_<int> body;             ///< as IdealView::body, of the surface whose depth was taken; nothing where no depth
};

/// Adds what the depth sensor does: disparity noise that neighbouring pixels share, quantisation, ragged outlines, and
/// no depth in shadows of projector and infrared camera, beside depth jumps, at grazing angles, on black surfaces and
/// in a margin of the image.
Measurement measure_depth(const IdealView& view, const Camera& camera, Random& random);

/// Adds what the colour camera does: blur, noise that grows with the light, 8 bits. CV_8UC3.
cv::Mat measure_colour(const IdealView& view, Random& random);

}  // namespace gestalt::synthesis
