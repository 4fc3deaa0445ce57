// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "gestalt/core/scene/frame.h"
#include "tolerances.h"

namespace gestalt {

/// The frame without colour at half its resolution, odd sizes rounded up; its camera sees the same. A depth is the mean
/// of the largest group of the (up to) four within omega(z) of one of them, of equal groups the nearest: no mean
/// crosses a depth jump.
Frame halve(const Frame& frame, const Tolerances& tolerances);

}  // namespace gestalt
