// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <numbers>

namespace gestalt::synthesis {

inline constexpr double degree = std::numbers::pi / 180;  ///< rad

}  // namespace gestalt::synthesis
