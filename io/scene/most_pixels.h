// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>

namespace gestalt {

/// Pixels of an image, or points of a cloud, that are read at most: an image that a stranger's header claims takes no
/// more memory than that. Messages and docs/formats.md call it 2^26.
constexpr std::int64_t most_pixels = std::int64_t{1} << 26;

/// Bytes of a cloud's points that are read at most; 2^31 in messages.
constexpr std::uint64_t most_cloud_bytes = std::uint64_t{1} << 31;

}  // namespace gestalt
