// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "measurement.h"
#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

/// Where the sensor's cameras and projectors stand along the colour camera's x axis, metres: what one of them does not
/// see has no depth.
std::vector<double> eyes_of(SensorModel sensor);

/// Adds what the depth sensor does. view: rendered for this sensor.
Measurement measure_depth(SensorModel sensor, const IdealView& view, const Camera& camera, Random& random);

}  // namespace gestalt::synthesis
