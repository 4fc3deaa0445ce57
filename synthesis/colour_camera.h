// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "random.h"
#include "render.h"

namespace gestalt::synthesis {

/// Adds what the colour camera does: blur, noise that grows with the light, 8 bits. CV_8UC3.
cv::Mat measure_colour(const IdealView& view, Random& random);

}  // namespace gestalt::synthesis
