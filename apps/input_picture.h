// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "gestalt/core/scene/frame.h"

namespace gestalt::app {

/// What was read, to be looked at, as the bytes of a PNG file: colour (grey where there is none) beside depth in
/// colours, red near, blue far, black without a measurement; each of at most 640 columns.
std::string input_picture(const Frame& frame);

}  // namespace gestalt::app
