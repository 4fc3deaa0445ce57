// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"
#include "measurement.h"
#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

// Two infrared cameras and a projector of texture: RealSense D415 and D435. The colour camera, to which depth is
// registered, stands 15 mm left of the left imager, so that all shadows lie on the left of things.

constexpr double left_imager_x = 0.015, right_imager_x = 0.065;  ///< metres along the colour camera's x axis
constexpr double imager_focal_length = 640;                      ///< pixels: D435 at 1280x720
/// Pixels times metres: disparity times depth.
constexpr double stereo_constant = imager_focal_length * (right_imager_x - left_imager_x);

/// The deviation of depth (metres) at z that an error in disparity (pixels) makes: z^2 / (f b) of it (Keselman et al.,
/// Intel RealSense stereoscopic depth cameras, CVPR workshops 2017).
double stereo_deviation(double z, double disparity_deviation);

/// Adds what matching by windows does: creases become round, the nearer surface grows over depth jumps, disparity noise
/// that neighbours share; no depth in shadows, left of what the right imager sees, in clumps beside jumps, on dark,
/// grazing and plain surfaces. How much of each is drawn once a call; one call in eight fills the holes from their
/// left, as the camera's software can.
Measurement measure_active_stereo(const IdealView& view, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
