// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/base/export.h"
#include "gestalt/core/config/surface_modelling_params.h"
#include "gestalt/core/scene/scene.h"

namespace gestalt {

/// The least number of columns, and rows, to one that leaves a frame of this size at most so many pixels; 1 where it
/// has no more, or where most_pixels is 0.
GESTALT_EXPORT int reduction(cv::Size size, int most_pixels);

/// The frame with one pixel for each block of factor x factor pixels, less at the right and lower edge: means of depth
/// and colour over one side of a depth jump, that of the block's median depth. A block has depth where a pixel has.
/// The same deadline.
GESTALT_EXPORT Frame reduced(const Frame& frame, int factor);

/// What was found in reduced(frame, factor), at the frame's resolution: a pixel with depth goes to the patch and
/// surface of its own or of a neighbouring block, by distance to the block's tangent plane, difference of colour and
/// distance in the image. All surfaces keep a pixel. Noise and deadline are those of found.
GESTALT_EXPORT std::shared_ptr<const Scene> enlarged(const Scene& found, const Frame& frame, int factor,
                                                     const SurfaceModellingParams& params);

}  // namespace gestalt
