// SPDX-FileCopyrightText: 2026 The Gestalt authors
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace gestalt {

/// Largest chunk of a bag, decompressed, bytes.
inline constexpr std::uint64_t largest_chunk = std::uint64_t{1} << 28;

/// A chunk's bytes. compression: "" or "none", "bz2", "lz4" (frames), "zstd". size: that the file tells. Throws
/// InputError, without the file's name, for damage, another size, more than largest_chunk and more than the bytes can
/// hold.
std::string decompressed(std::string_view bytes, std::string_view compression, std::uint64_t size);

}  // namespace gestalt
