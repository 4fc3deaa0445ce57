// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>

namespace gestalt {

/// Bytes that deflate makes of one at most (zlib's technical details).
constexpr std::uint64_t most_inflated = 1032;

}  // namespace gestalt
