// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"
#include "measurement.h"
#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

// The structured-light sensor of the first Kinect.

/// The colour camera of a Kinect, to which depth is registered, stands between the infrared camera (on its left) and
/// the projector (right): what either of them does not see has no depth. Metres along the camera's x axis. Their
/// distance, 7.5 cm, is the baseline of Khoshelham & Elberink (2012).
constexpr double infrared_camera_x = -0.025, projector_x = 0.05;

constexpr double infrared_focal_length = 580;  ///< pixels (Khoshelham & Elberink 2012: 5.453 mm / 9.3 um = 586)
constexpr double disparity_step = 1.0 / 8;     ///< pixels: the sensor interpolates to an eighth
/// Of the measured disparity: half a step (Khoshelham & Elberink 2012, Eq. 9: sigma_z = 1.425e-3 z^2 m).
constexpr double disparity_deviation = disparity_step / 2;
constexpr double lateral_deviation = 0.8;  ///< pixels by which outlines wander (Nguyen, Izadi, Lovell 2012)

/// The distance of two depths that the sensor tells apart around z: 2.87e-3 z^2 m.
double depth_step(double z);

/// Adds what the depth sensor does: disparity noise that neighbouring pixels share, quantisation, ragged outlines, and
/// no depth in shadows of projector and infrared camera, beside depth jumps, at grazing angles, on black surfaces and
/// in a margin of the image.
Measurement measure_structured_light(const IdealView& view, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
