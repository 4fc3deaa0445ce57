// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <opencv2/core.hpp>

#include "gestalt/core/scene/frame.h"

namespace gestalt {

/// CV_8UC3: the colour image, or depth as grey from near (bright) to far.
cv::Mat backdrop(const Frame& frame);

}  // namespace gestalt
