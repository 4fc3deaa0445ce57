// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// How noisy the depth of a frame is, as a multiple of `noise`, a model of its growth with depth. From the frame's own
/// smooth surfaces: a plane is fitted to square windows, 3.7 degrees wide, and the deviation from it counted in units
/// of `noise`. A tenth of the windows deviates less than the result: those hold no edge and nothing curved, on a
/// cluttered frame, too. Nothing when fewer than 40 windows are measured for the most part. The same for any number of
/// threads.
GESTALT_EXPORT std::optional<double> estimate_noise(const Frame& frame, const DepthNoise& noise);

}  // namespace gestalt
