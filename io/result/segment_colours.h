// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>
#include <vector>

#include "gestalt/core/base/export.h"
#include "gestalt/core/scene/segmentation.h"

namespace gestalt {

/// Colours (blue, green, red) of the segments of a result, by label - 1, for overlay.png and the Inspector. Objects
/// that are at most 8 pixels apart differ clearly, the largest are coloured first; background is black. The same
/// segmentation gives the same colours.
GESTALT_EXPORT std::vector<cv::Vec3b> segment_colours(const Segmentation& segmentation);

}  // namespace gestalt
